#!/usr/bin/env python3
"""Reads the one-line FN signatures, structs and doc comments of kernels/ and writes what is made of them.

  kernel_index.py KERNELS OUT

writes OUT/kernel_index.cpp (the index for the host, with the kernels' text for OpenGL) and OUT/<group>.inc for each folder of
kernels/ (C++ entry points, included inside a target's namespace). A mistake in a kernel is an error with file and line.
"""
import pathlib
import re
import sys

TYPES = {"Float": 1, "Vec2": 2, "Vec3": 3, "Vec4": 4, "Bool": 1, "Scalar": 1, "Scalar4": 4, "int": 1}
TABLES = {"Table2", "Table3"}
UNIFORM = {"Scalar", "Scalar4", "int"}
REFUSED = ("pow acos asin atan log log2 exp2 tan inversesqrt mod fract sign step length distance normalize cross reflect refract "
           "smoothstep round trunc ceil isnan isinf dFdx dFdy texture texelFetch textureSize").split()


class Fail(Exception):
    pass


def fail(file, line, text):
    raise Fail(f"{file}:{line}: {text}")


def number(text):
    return float(text)


def parse_range(file, line, rest):
    """'[unit] in low..high log  text' -> (unit, low, high, logarithmic, text)"""
    match = re.match(r"\s*\[([^\]]*)\]\s*(?:in\s+([-+0-9.eE]+?)\.\.([-+0-9.eE]+)( log)?)?\s*(.*)$", rest)
    if not match:
        fail(file, line, f"expected '[unit] in low..high  text', found '{rest.strip()}'")
    unit, low, high, log, text = match.groups()
    return unit, number(low) if low else 0.0, number(high) if high else 0.0, bool(log), text.strip(), low is not None


class Argument:
    def __init__(self, name, type, out=False):
        self.name, self.type, self.out = name, type, out
        self.unit, self.low, self.high, self.log, self.text, self.ranged = "", 0.0, 0.0, False, "", False


class Kernels:
    def __init__(self, root):
        self.root = root
        self.structs, self.functions, self.files, self.order = {}, [], {}, {}
        self.groups = sorted(p.name for p in root.iterdir() if p.is_dir() and p.name != "prelude")
        self.groups.remove("core")
        self.groups.insert(0, "core")
        for group in self.groups:
            self.order[group] = []
            for path in sorted((root / group).glob("*.glsl")):
                self.visit(path.relative_to(root).as_posix(), self.order[group])

    def visit(self, file, order):
        if file in order:
            return
        if file not in self.files:
            path = self.root / file
            if not path.exists():
                raise Fail(f"kernels/{file}: included but not there")
            self.files[file] = path.read_text()
            self.read(file)
        for name in re.findall(r'^#include "([^"]+)"', self.files[file], re.M):
            self.visit(name, order)
        order.append(file)

    def read(self, file):
        lines = self.files[file].splitlines()
        group = file.split("/")[0]
        comment, struct = [], None
        for at, line in enumerate(lines, 1):
            code = line.split("//")[0]
            for word in re.findall(r"\b([a-z]\w*)\s*\(", code):
                if word in REFUSED:
                    fail("kernels/" + file, at, f"'{word}' is not in the kernel language (see kernels/core/math.glsl)")
            if re.search(r"\b\d+\.\d*([eE][-+]?\d+)?[fFlL]\b", code):
                fail("kernels/" + file, at, "literals carry no suffix")
            if re.match(r"\s*#\s*(?!include|pragma)", code):
                fail("kernels/" + file, at, "no preprocessor in kernels but #include and #pragma once")
            if "?" in code:
                fail("kernels/" + file, at, "use select() in place of ?:")
            if line.startswith("///"):
                comment.append((at, line[3:].strip()))
                continue
            match = re.match(r"struct (\w+) \{", line)
            if match:
                struct = match.group(1)
                self.structs[struct] = []
                comment = []
                continue
            if struct:
                if line.startswith("};"):
                    struct = None
                    continue
                match = re.match(r"\s+(Scalar4?) (\w+);\s*//\s*(.*)$", line)
                if not match:
                    fail("kernels/" + file, at, "a parameter struct holds 'Scalar name;  // [unit] in low..high  text' lines only")
                field = Argument(match.group(2), match.group(1))
                field.unit, field.low, field.high, field.log, field.text, field.ranged = parse_range("kernels/" + file, at, match.group(3))
                self.structs[struct].append(field)
                continue
            if re.match(r"FN(_SHARED)? ", line):
                self.function(file, at, group, line, lines, comment)
            if line.strip():
                comment = []
        for name, fields in self.structs.items():
            if sum(TYPES[f.type] for f in fields) % 4:
                raise Fail(f"kernels/{file}: struct {name} must be padded to a multiple of four Scalars (std140)")

    def function(self, file, at, group, line, lines, comment):
        where = "kernels/" + file
        text, end = line, at
        while "{" not in text:  # a signature may run on
            end += 1
            text += " " + lines[end - 1].strip()
        match = re.match(r"FN(?:_SHARED)? (\w+) (\w+)\((.*)\)\s*$", text.split("{")[0].strip())
        if not match:
            fail(where, at, "cannot read this signature")
        result, name, list_ = match.groups()
        f = type("Function", (), {})()
        f.kernel_name, f.result, f.file, f.line, f.group = name, result, file, at, group
        prefix = "" if group == "core" else group + "_"
        if prefix and not name.startswith(prefix):
            fail(where, at, f"functions of kernels/{group} begin with '{prefix}'")
        f.name = group + "." + name[len(prefix):]
        f.arguments = []
        for item in re.sub(r"(IN|OUT)\((\w+)\)", r"\1 \2", list_).split(","):
            words = item.split()
            out = words[0] == "OUT"
            if words[0] in ("IN", "OUT"):
                words = words[1:]
            if len(words) != 2:
                fail(where, at, f"cannot read argument '{item.strip()}'")
            f.arguments.append(Argument(words[1], words[0], out))
        f.text, f.bound, f.scale, f.reason, f.unit = "", 2e-5, 1.0, "", ""
        documented = {}
        for row, words in comment:
            if words.startswith("@param "):
                _, name_, rest = words.split(None, 2)
                documented[name_] = (row, rest)
            elif words.startswith("@bound "):
                m = re.match(r"@bound\s+([-+0-9.eE]+)\s+scale\s+([-+0-9.eE]+)\s*(.*)$", words)
                if not m:
                    fail(where, row, "expected '@bound 2e-5 scale 1  reason'")
                f.bound, f.scale, f.reason = float(m.group(1)), float(m.group(2)), m.group(3)
            elif not words.startswith("@"):
                f.text = (f.text + " " + words).strip()
        if not f.text:
            fail(where, at, f"{f.kernel_name} has no doc comment")
        units = re.findall(r"\[([^\]]+)\]", f.text)
        f.unit = units[0] if units else ""
        f.passes = f.kernel_name.endswith("_pass")
        f.evaluable = not f.passes and not any(a.type in TABLES for a in f.arguments)
        for a in f.arguments:
            if a.name in documented:
                row, rest = documented.pop(a.name)
                a.unit, a.low, a.high, a.log, a.text, a.ranged = parse_range(where, row, rest)
            if f.evaluable and a.type in TYPES and not a.out and not a.ranged:
                fail(where, at, f"{f.kernel_name}: argument '{a.name}' needs '/// @param {a.name} [unit] in low..high'")
            if a.type not in TYPES and not a.type in TABLES and a.type not in self.structs:
                fail(where, at, f"{f.kernel_name}: unknown type '{a.type}'")
        for name_, (row, _) in documented.items():
            fail(where, row, f"{f.kernel_name} has no argument '{name_}'")
        if f.passes:
            f.name = f.name[:-len("_pass")]
            if f.arguments[-1].name not in ("uv", "uvw") and not f.arguments[-1].out:
                fail(where, at, "a pass takes Vec2 uv or Vec3 uvw, then its OUT(Vec4)s")
        self.functions.append(f)


def quote(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


def raw(text):
    # A string literal may be at most 65536 characters by the standard: in pieces.
    pieces = [text[i:i + 8000] for i in range(0, len(text), 8000)]
    return "\n".join('R"glsl(' + piece + ')glsl"' for piece in pieces)


def argument_info(a):
    kind = {"int": "Int"}.get(a.type, a.type if a.type in TYPES or a.type in TABLES else "Struct")
    struct = a.type if kind == "Struct" else ""
    return (f"{{{quote(a.name)}, KernelType::{kind}, {quote(struct)}, {str(a.out).lower()}, {quote(a.unit)}, {a.low!r}, {a.high!r}, "
            f"{str(a.log).lower()}, {quote(a.text)}}}")


def index(k):
    out = ["// Generated by tools/kernel_index.py.", '#include "engine/kernel_index.h"', "namespace airlight {", "namespace {"]
    names = {file: f"source_{i}" for i, file in enumerate(sorted(k.files))}
    for file, name in names.items():
        out.append(f"constexpr KernelSource {name}{{{quote('kernels/' + file)}, {raw(k.files[file])}}};")
    prelude = (k.root / "prelude" / "prelude.glsl").read_text()
    out.append(f'constexpr KernelSource prelude{{"kernels/prelude/prelude.glsl", {raw(prelude)}}};')
    for g in k.groups:
        out.append(f"constexpr const KernelSource* sources_{g}[] = {{&prelude, " + ", ".join("&" + names[f] for f in k.order[g]) + "};")
    out.append("constexpr KernelGroup groups[] = {" + ", ".join(f"{{{quote(g)}, sources_{g}}}" for g in k.groups) + "};")
    for s, fields in k.structs.items():
        out.append(f"constexpr ArgumentInfo fields_{s}[] = {{" + ",\n  ".join(argument_info(f) for f in fields) + "};")
    out.append("constexpr StructInfo structs[] = {" + ", ".join(
        f"{{{quote(s)}, fields_{s}, {sum(TYPES[f.type] for f in fields)}}}" for s, fields in k.structs.items()) + "};")
    functions, passes = [], []
    slots = {}
    for i, f in enumerate(k.functions):
        group = k.groups.index(f.group)
        slot = slots[(group, f.passes)] = slots.get((group, f.passes), -1) + (1 if f.passes or f.evaluable else 0)
        if f.passes:
            structs = [a for a in f.arguments if a.type in k.structs]
            tables = [a for a in f.arguments if a.type in TABLES]
            outs = [f.name.split(".")[1]] + [a.name for a in f.arguments if a.out]
            for kind, items in (("structs", structs), ("tables", tables)):
                out.append(f"[[maybe_unused]] constexpr std::array<ArgumentInfo, {len(items)}> pass_{kind}_{i}{{{{" + ", ".join(argument_info(a) for a in items) + "}};")
            out.append(f"constexpr std::string_view outputs_{i}[] = {{" + ", ".join(quote(o) for o in outs) + "};")
            slices = any(a.name == "uvw" for a in f.arguments)
            passes.append(f"{{{quote(f.name)}, {quote(f.kernel_name)}, pass_structs_{i}, pass_tables_{i}, outputs_{i}, {str(slices).lower()}, "
                          f"{quote('kernels/' + f.file)}, {f.line}, {group}, {slot}}}")
        else:
            out.append(f"constexpr ArgumentInfo arguments_{i}[] = {{" + ",\n  ".join(argument_info(a) for a in f.arguments) + "};")
            kind = f.result if f.result in TYPES else "Struct"
            functions.append(f"{{{quote(f.name)}, {quote(f.kernel_name)}, {quote(f.unit)}, {quote(f.text)}, KernelType::{kind}, "
                             f"{str(f.result == 'void').lower()}, arguments_{i}, {f.bound!r}, {f.scale!r}, {quote('kernels/' + f.file)}, {f.line}, "
                             f"{group}, {slot if f.evaluable else -1}, {str(f.evaluable).lower()}}}")
    out.append("constexpr FunctionInfo functions[] = {" + ",\n  ".join(functions) + "};")
    out.append("constexpr PassInfo passes[] = {" + ",\n  ".join(passes) + "};")
    out += ["}  // namespace", "std::span<const FunctionInfo> kernel_functions() { return functions; }",
            "std::span<const PassInfo> kernel_passes() { return passes; }", "std::span<const StructInfo> kernel_structs() { return structs; }",
            "std::span<const KernelGroup> kernel_groups() { return groups; }", "}  // namespace airlight", ""]
    out.insert(1, "#include <array>")
    return "\n".join(out)


def component(prefix, type, at):
    """C++ that loads one value of a type from component `at` on."""
    if type in ("Float", "Scalar"):
        return f"{prefix}({at})"
    if type == "Bool":
        return f"({prefix}({at}) > 0.5)"
    if type == "int":
        return f"int({prefix}({at}))"
    return f"{type}(" + ", ".join(f"{prefix}({at + i})" for i in range(TYPES[type])) + ")"


def wrappers(k, group):
    out = ["// Generated by tools/kernel_index.py: included inside a target's namespace, after the kernels."]
    evals, passes = [], []
    for f in k.functions:
        if f.group != group:
            continue
        lines = []
        if f.evaluable:
            uniform = varying = result = 0
            body, call = [], []
            for a in f.arguments:
                if a.out:
                    body.append(f"    {a.type} {a.name}_out{{}};")
                    call.append(a.name + "_out")
                elif a.type in k.structs:
                    lines.append(f"  {a.type} {a.name}_in; unpack(a.uniforms + {uniform}, {a.name}_in);")
                    uniform += sum(TYPES[x.type] for x in k.structs[a.type])
                    call.append(a.name + "_in")
                elif a.type in UNIFORM:
                    lines.append(f"  const {a.type} {a.name}_in = " + component("a.uniform", a.type, uniform) + ";")
                    uniform += TYPES[a.type]
                    call.append(a.name + "_in")
                else:
                    body.append(f"    const {a.type} {a.name}_in = " + component("in.get", a.type, varying) + ";")
                    varying += TYPES[a.type]
                    call.append(a.name + "_in")
            invocation = f"{f.kernel_name}({', '.join(call)})"
            if f.result == "void":
                body.append(f"    {invocation};")
            else:
                body.append(f"    const {f.result} result = {invocation};")
                body.append(f"    put(in, {result}, result);")
                result += TYPES[f.result]
            for a in f.arguments:
                if a.out:
                    body.append(f"    put(in, {result}, {a.name}_out);")
                    result += TYPES[a.type]
            out += [f"static void eval_{f.kernel_name}(const EvalArguments& a) {{"] + lines
            out += ["  for (int at = 0; at < a.count; at += lanes) {", "    const Batch in{a, at};"] + body + ["  }", "}"]
            evals.append("eval_" + f.kernel_name)
        elif f.passes:
            at = table = 0
            call, outs = [], ["result"]
            for a in f.arguments:
                if a.out:
                    call.append(a.name + "_out")
                    outs.append(a.name + "_out")
                elif a.type in k.structs:
                    lines.append(f"  {a.type} {a.name}_in; unpack(a.parameters + {at}, {a.name}_in);")
                    at += sum(TYPES[x.type] for x in k.structs[a.type])
                    call.append(a.name + "_in")
                elif a.type in TABLES:
                    lines.append(f"  const {a.type} {a.name}_in = make_{a.type}(a.tables[{table}]);")
                    table += 1
                    call.append(a.name + "_in")
                else:
                    call.append("coordinates" if a.name == "uvw" else "Vec2(coordinates.x, coordinates.y)")
            declare = " ".join(f"Vec4 {o} = Vec4(0.0);" for o in outs[1:])
            out += [f"static void pass_{f.kernel_name}(const PassArguments& a) {{"] + lines
            out += ["  for_each_texel(a, [&](const Vec3& coordinates, Vec4* outputs) {", f"    {declare}" if declare else "",
                    f"    const Vec4 result = {f.kernel_name}({', '.join(call)});"]
            out += [f"    outputs[{i}] = {o};" for i, o in enumerate(outs)] + ["  });", "}"]
            passes.append("pass_" + f.kernel_name)
    out = [line for line in out if line]
    out.append("static constexpr EvalEntry evals[] = {" + ", ".join(evals + ["nullptr"]) + "};")
    out.append("static constexpr PassEntry passes[] = {" + ", ".join(passes + ["nullptr"]) + "};")
    includes = "\n".join(f'#include "{f}"' for f in k.order[group])
    return includes + "\n" + "\n".join(out) + "\n"


def write(path, text):
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
    except Fail as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
