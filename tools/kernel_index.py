#!/usr/bin/env python3
"""Reads the one-line FN signatures, structs and doc comments of kernels/ and writes what is made of them.

  kernel_index.py KERNELS OUT

writes OUT/kernel_index.cpp (the index for the host, with the kernels' text for OpenGL) and OUT/<group>.inc for each
folder of kernels/ (C++ entry points, included inside a target's namespace). A mistake in a kernel is an error with file
and line.
"""
import pathlib
import re
import sys
from dataclasses import dataclass

TYPES = {"Float": 1, "Vec2": 2, "Vec3": 3, "Vec4": 4, "Bool": 1, "Scalar": 1, "Scalar4": 4, "int": 1}  # numbers in each
TABLES = {"Table2", "Table3"}
UNIFORM = {"Scalar", "Scalar4", "int"}
REFUSED = set("pow acos asin atan log log2 exp2 tan inversesqrt mod fract sign step length distance normalize cross "
              "reflect refract smoothstep round trunc ceil isnan isinf dFdx dFdy texture texelFetch "
              "textureSize".split())
# Words that GLSL keeps for itself and C++ does not.
RESERVED = set("flat smooth noperspective centroid invariant patch sample shared precise coherent restrict readonly writeonly "
               "buffer uniform varying attribute layout subroutine input output filter half fixed common partition active".split())


class Fail(Exception):
    pass


@dataclass
class Place:
    file: str  # below kernels/
    line: int = 0

    def fail(self, text, line=None):
        raise Fail(f"kernels/{self.file}:{line or self.line}: {text}")


# ---- What a kernel says ----


@dataclass
class Argument:
    """An argument of a function, or a field of a struct."""
    name: str
    type: str
    out: bool = False
    unit: str = ""
    low: float = 0.0
    high: float = 0.0
    log: bool = False
    text: str = ""
    ranged: bool = False  # a range was stated

    def describe(self, text, place):
        """Takes '[unit] in low..high log  text'; all but the unit may be missing."""
        match = re.match(r"\s*\[([^\]]*)\]\s*(?:in\s+([-+0-9.eE]+?)\.\.([-+0-9.eE]+)( log)?)?\s*(.*)$", text)
        if not match:
            place.fail(f"expected '[unit] in low..high  text', found '{text.strip()}'")
        self.unit, low, high, log, words = match.groups()
        self.low, self.high, self.log, self.text = float(low or 0), float(high or 0), bool(log), words.strip()
        self.ranged = low is not None


@dataclass
class Function:
    kernel_name: str
    result: str
    place: Place
    arguments: list
    text: str = ""
    bound: float = 2e-5
    scale: float = 1.0

    @property
    def group(self):
        return self.place.file.split("/")[0]

    @property
    def name(self):
        """Outside: core.phase_rayleigh for phase_rayleigh, skyview.multiple for skyview_multiple_pass in skyview/."""
        prefix = "" if self.group == "core" else self.group + "_"
        return self.group + "." + self.kernel_name.removeprefix(prefix).removesuffix("_pass")

    @property
    def is_pass(self):
        return self.kernel_name.endswith("_pass")

    @property
    def evaluable(self):
        return not self.is_pass and not any(a.type in TABLES for a in self.arguments)

    @property
    def unit(self):
        """The result's: the first one that the comment names."""
        named = re.search(r"\[([^\]]+)\]", self.text)
        return named.group(1) if named else ""


# ---- Reading ----


class Kernels:
    def __init__(self, root):
        self.root = root
        self.files = {}  # text by name
        self.structs = {}  # fields by name
        self.functions = []
        self.order = {}  # by group: its files, what is included before what includes it
        folders = sorted(p.name for p in root.iterdir() if p.is_dir())
        self.groups = ["core"] + [name for name in folders if name not in ("core", "prelude")]
        for group in self.groups:
            self.order[group] = []
            for path in sorted((root / group).glob("*.glsl")):
                self.visit(path.relative_to(root).as_posix(), self.order[group])

    def visit(self, file, order):
        if file in order:
            return
        unread = file not in self.files
        if unread:
            path = self.root / file
            if not path.exists():
                raise Fail(f"kernels/{file}: included but not there")
            self.files[file] = path.read_text()
        for name in re.findall(r'^#include "([^"]+)"', self.files[file], re.M):
            self.visit(name, order)
        if unread:
            self.read(file)
        order.append(file)

    def read(self, file):
        lines = self.files[file].splitlines()
        comment, struct = [], None  # the doc comment above: (line, text); the struct that we are in
        for at, line in enumerate(lines, 1):
            place = Place(file, at)
            check_language(line.split("//")[0], place)
            if line.startswith("///"):
                comment.append((at, line[3:].strip()))
                continue
            if opened := re.match(r"struct (\w+) \{", line):
                struct = opened.group(1)
                self.structs[struct] = []
            elif struct and line.startswith("};"):
                if self.numbers(struct) % 4:
                    place.fail(f"struct {struct} must be padded to a multiple of four Scalars (std140)")
                struct = None
            elif struct:
                self.structs[struct].append(read_field(line, place))
            elif re.match(r"FN(_SHARED)? ", line):
                self.functions.append(self.read_function(lines, comment, place))
            if line.strip():
                comment = []

    def read_function(self, lines, comment, place):
        signature, end = lines[place.line - 1], place.line
        while "{" not in signature:  # it may run on
            signature += " " + lines[end].strip()
            end += 1
        match = re.match(r"FN(?:_SHARED)? (\w+) (\w+)\((.*)\)\s*$", signature.split("{")[0].strip())
        if not match:
            place.fail("cannot read this signature")
        result, name, arguments = match.groups()
        f = Function(name, result, place, [read_argument(text, place) for text in arguments.split(",")])
        if f.group != "core" and not name.startswith(f.group + "_"):
            place.fail(f"functions of kernels/{f.group} begin with '{f.group}_'")
        read_comment(f, comment)
        for a in f.arguments:
            if a.type not in TYPES and a.type not in TABLES and a.type not in self.structs:
                place.fail(f"{name}: unknown type '{a.type}'")
            if f.evaluable and a.type in TYPES and not a.out and not a.ranged:
                place.fail(f"{name}: argument '{a.name}' needs '/// @param {a.name} [unit] in low..high'")
        if f.is_pass and f.arguments[-1].name not in ("uv", "uvw") and not f.arguments[-1].out:
            place.fail("a pass takes Vec2 uv or Vec3 uvw, then its OUT(Vec4)s")
        return f

    def numbers(self, type):
        """How many numbers a value of a type holds."""
        return TYPES[type] if type in TYPES else sum(TYPES[f.type] for f in self.structs[type])


def check_language(code, place):
    for word in re.findall(r"\b[a-z]\w*\b", code):
        if word in RESERVED:
            place.fail(f"'{word}' is a word of GLSL's own")
    for word in re.findall(r"\b([a-z]\w*)\s*\(", code):
        if word in REFUSED:
            place.fail(f"'{word}' is not in the kernel language (see kernels/core/math.glsl)")
    if re.search(r"\b\d+\.\d*([eE][-+]?\d+)?[fFlL]\b", code):
        place.fail("literals carry no suffix")
    if re.match(r"\s*#\s*(?!include|pragma)", code):
        place.fail("no preprocessor in kernels but #include and #pragma once")
    if "?" in code:
        place.fail("use select() in place of ?:")


def read_field(line, place):
    match = re.match(r"\s+(Scalar4?) (\w+);\s*//\s*(.*)$", line)
    if not match:
        place.fail("a parameter struct holds 'Scalar name;  // [unit] in low..high  text' lines only")
    a = Argument(match.group(2), match.group(1))
    a.describe(match.group(3), place)
    return a


def read_argument(text, place):
    """'Float x', 'IN(Air) air', 'OUT(Vec4) sky'."""
    match = re.match(r"\s*(?:(IN|OUT)\((\w+)\)|(\w+))\s+(\w+)\s*$", text)
    if not match:
        place.fail(f"cannot read argument '{text.strip()}'")
    qualifier, qualified, plain, name = match.groups()
    return Argument(name, qualified or plain, qualifier == "OUT")


def read_comment(f, comment):
    """The text, '@param name [unit] in low..high' and '@bound 2e-5 scale 1  reason'."""
    for line, words in comment:
        if words.startswith("@param "):
            _, name, rest = words.split(None, 2)
            named = [a for a in f.arguments if a.name == name]
            if not named:
                f.place.fail(f"{f.kernel_name} has no argument '{name}'", line)
            named[0].describe(rest, Place(f.place.file, line))
        elif words.startswith("@bound "):
            match = re.match(r"@bound\s+([-+0-9.eE]+)\s+scale\s+([-+0-9.eE]+)", words)
            if not match:
                f.place.fail("expected '@bound 2e-5 scale 1  reason'", line)
            f.bound, f.scale = map(float, match.groups())
        elif not words.startswith("@"):
            f.text = (f.text + " " + words).strip()
    if not f.text:
        f.place.fail(f"{f.kernel_name} has no doc comment")


# ---- Writing the index: src/engine/kernel_index.h declares it ----


def quote(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


def raw(text):
    # A string literal may be at most 65536 characters by the standard: in pieces.
    pieces = [text[i:i + 8000] for i in range(0, len(text), 8000)]
    return "\n".join('R"glsl(' + piece + ')glsl"' for piece in pieces)


def boolean(value):
    return "true" if value else "false"


def kernel_type(type):
    known = type in TYPES or type in TABLES
    return "KernelType::" + ("Int" if type == "int" else type if known else "Struct")


def braces(*items):
    return "{" + ", ".join(str(item) for item in items) + "}"


def array(declaration, items, separator=", "):
    return f"constexpr {declaration}[] = {{" + separator.join(items) + "};"


def argument_info(a):
    kind = kernel_type(a.type)
    struct = a.type if kind.endswith("Struct") else ""
    return braces(quote(a.name), kind, quote(struct), boolean(a.out), quote(a.unit), repr(a.low), repr(a.high),
                  boolean(a.log), quote(a.text))


def index_sources(k):
    names = {file: f"source_{i}" for i, file in enumerate(sorted(k.files))}
    for file, name in names.items():
        yield f"constexpr KernelSource {name}{{{quote('kernels/' + file)}, {raw(k.files[file])}}};"
    prelude = (k.root / "prelude" / "prelude.glsl").read_text()
    yield f'constexpr KernelSource prelude{{"kernels/prelude/prelude.glsl", {raw(prelude)}}};'
    for g in k.groups:
        yield array(f"const KernelSource* sources_{g}", ["&prelude"] + ["&" + names[file] for file in k.order[g]])
    yield array("KernelGroup groups", [braces(quote(g), f"sources_{g}") for g in k.groups])


def index_structs(k):
    for name, fields in k.structs.items():
        yield array(f"ArgumentInfo fields_{name}", map(argument_info, fields), ",\n  ")
    yield array("StructInfo structs", [braces(quote(name), f"fields_{name}", k.numbers(name)) for name in k.structs])


def index_functions(k):
    functions, passes = [], []
    used = {}  # slots, by group and kind: places in the lists that wrappers() writes
    for i, f in enumerate(k.functions):
        slot = -1
        if f.is_pass or f.evaluable:
            slot = used[f.group, f.is_pass] = used.get((f.group, f.is_pass), -1) + 1
        names = [quote(f.name), quote(f.kernel_name)]
        place = [quote("kernels/" + f.place.file), f.place.line, k.groups.index(f.group), slot]
        if f.is_pass:
            for kind, known in (("structs", k.structs), ("tables", TABLES)):
                items = [argument_info(a) for a in f.arguments if a.type in known]
                # Not a plain array: those have at least one element.
                yield (f"[[maybe_unused]] constexpr std::array<ArgumentInfo, {len(items)}> "
                       f"pass_{kind}_{i}{{{braces(*items)}}};")
            outputs = [f.name.split(".")[1]] + [a.name for a in f.arguments if a.out]
            yield array(f"std::string_view outputs_{i}", map(quote, outputs))
            slices = boolean(any(a.name == "uvw" for a in f.arguments))
            passes.append(braces(*names, f"pass_structs_{i}", f"pass_tables_{i}", f"outputs_{i}", slices, *place))
        else:
            yield array(f"ArgumentInfo arguments_{i}", map(argument_info, f.arguments), ",\n  ")
            functions.append(braces(*names, quote(f.unit), quote(f.text), kernel_type(f.result),
                                    boolean(f.result == "void"), f"arguments_{i}", repr(f.bound), repr(f.scale), *place,
                                    boolean(f.evaluable)))
    yield array("FunctionInfo functions", functions, ",\n  ")
    yield array("PassInfo passes", passes, ",\n  ")


def index(k):
    return "\n".join([
        "// Generated by tools/kernel_index.py.", "#include <array>", '#include "engine/kernel_index.h"',
        "namespace airlight {", "namespace {", *index_sources(k), *index_structs(k), *index_functions(k),
        "}  // namespace",
        "std::span<const FunctionInfo> kernel_functions() { return functions; }",
        "std::span<const PassInfo> kernel_passes() { return passes; }",
        "std::span<const StructInfo> kernel_structs() { return structs; }",
        "std::span<const KernelGroup> kernel_groups() { return groups; }", "}  // namespace airlight", ""])


# ---- Writing a target's entry points: src/engine/cpu/target.cpp includes them ----


def component(read, type, at):
    """C++ that loads one value of a type from number `at` on."""
    if type in ("Float", "Scalar"):
        return f"{read}({at})"
    if type == "Bool":
        return f"({read}({at}) > 0.5)"
    if type == "int":
        return f"int({read}({at}))"
    return f"{type}(" + ", ".join(f"{read}({at + i})" for i in range(TYPES[type])) + ")"


def eval_entry(k, f):
    """Evaluates a function for many arguments: uniforms are read once, the rest for each batch of lanes."""
    once, each, call, results = [], [], [], []
    uniform = varying = 0
    for a in f.arguments:
        name = a.name + ("_out" if a.out else "_in")
        call.append(name)
        if a.out:
            each.append(f"{a.type} {name}{{}};")
        elif a.type in k.structs:
            once.append(f"{a.type} {name}; unpack(a.uniforms + {uniform}, {name});")
            uniform += k.numbers(a.type)
        elif a.type in UNIFORM:
            once.append(f"const {a.type} {name} = " + component("a.uniform", a.type, uniform) + ";")
            uniform += TYPES[a.type]
        else:
            each.append(f"const {a.type} {name} = " + component("in.get", a.type, varying) + ";")
            varying += TYPES[a.type]
    invocation = f"{f.kernel_name}({', '.join(call)});"
    if f.result == "void":
        each.append(invocation)
    else:
        each.append(f"const {f.result} result = {invocation}")
        results.append((f.result, "result"))
    results += [(a.type, a.name + "_out") for a in f.arguments if a.out]
    at = 0
    for type, name in results:
        each.append(f"put(in, {at}, {name});")
        at += TYPES[type]
    return [f"static void eval_{f.kernel_name}(const EvalArguments& a) {{", *("  " + line for line in once),
            "  for (int at = 0; at < a.count; at += lanes) {", "    const Batch in{a, at};",
            *("    " + line for line in each), "  }", "}"]


def pass_entry(k, f):
    """Runs a pass over a grid."""
    once, call = [], []
    parameter = table = 0
    for a in f.arguments:
        name = a.name + ("_out" if a.out else "_in")
        if a.type in k.structs:
            once.append(f"{a.type} {name}; unpack(a.parameters + {parameter}, {name});")
            parameter += k.numbers(a.type)
        elif a.type in TABLES:
            once.append(f"const {a.type} {name} = make_{a.type}(a.tables[{table}]);")
            table += 1
        elif not a.out:
            name = "coordinates" if a.name == "uvw" else "Vec2(coordinates.x, coordinates.y)"
        call.append(name)
    outputs = [a.name + "_out" for a in f.arguments if a.out]
    each = [" ".join(f"Vec4 {name} = Vec4(0.0);" for name in outputs)] if outputs else []
    each.append(f"const Vec4 result = {f.kernel_name}({', '.join(call)});")
    each += [f"outputs[{i}] = {name};" for i, name in enumerate(["result"] + outputs)]
    return [f"static void pass_{f.kernel_name}(const PassArguments& a) {{", *("  " + line for line in once),
            "  for_each_texel(a, [&](const Vec3& coordinates, Vec4* outputs) {", *("    " + line for line in each),
            "  });", "}"]


def wrappers(k, group):
    lines = [f'#include "{file}"' for file in k.order[group]]
    lines.append("// Generated by tools/kernel_index.py: included inside a target's namespace, after the kernels.")
    evals = [f for f in k.functions if f.group == group and f.evaluable and not f.is_pass]
    passes = [f for f in k.functions if f.group == group and f.is_pass]
    entries = lambda kind, functions: [f"{kind}_{f.kernel_name}" for f in functions] + ["nullptr"]
    lines += [line for f in evals for line in eval_entry(k, f)]
    # An array has at least one element, so each list ends with a null.
    lines.append("static " + array(f"EvalEntry evals_{group}", entries("eval", evals)))
    lines.append("#ifdef AIRLIGHT_FUNCTIONS_ALONE")
    lines.append("static " + array(f"PassEntry passes_{group}", entries("pass", [])))
    lines.append("#else")
    lines += [line for f in passes for line in pass_entry(k, f)]
    lines.append("static " + array(f"PassEntry passes_{group}", entries("pass", passes)))
    lines.append("#endif")
    return "\n".join(lines) + "\n" + groups_macro([group])


def groups_macro(groups):
    """Tells the unit that includes it which groups it holds."""
    return "#undef AIRLIGHT_GROUPS\n#define AIRLIGHT_GROUPS(X) " + " ".join(f"X({g})" for g in groups) + "\n"


def every_group(k):
    """All groups in one translation unit, with the passes of the first alone: less to compile where the number type is costly and
    functions are what is run."""
    first, *others = (f'#include "{g}.inc"\n' for g in k.groups)
    return first + "#define AIRLIGHT_FUNCTIONS_ALONE\n" + "".join(others) + groups_macro(k.groups)


def write(path, text):
    """Leaves a file that already says so alone: nothing that depends on it is built again."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def main():
    root, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    try:
        kernels = Kernels(root)
        write(out / "kernel_index.cpp", index(kernels))
        for group in kernels.groups:
            write(out / f"{group}.inc", wrappers(kernels, group))
        write(out / "every_group.inc", every_group(kernels))
    except Fail as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
