// Finds what a pass's arguments name: parameter structs and tables, by the names of the arguments.
#pragma once
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "airlight/engine.h"
#include "engine/kernel_index.h"
#include "model/model.h"

namespace airlight {

class Binder {
 public:
  Binder(Engine& engine, const Model& model, const Situation& situation)
      : engine_(engine), model_(model), situation_(situation) {}

  /// Tables that the model made on the host, by argument.
  using HostTables = std::map<std::string, Table, std::less<>>;
  /// Where those are kept, for binders of the same parameters.
  void keep_host_tables(HostTables& kept) { host_tables_ = &kept; }

  /// For one of the frames that a picture gathers.
  void set_earlier(int frames) { situation_.earlier = frames; }

  void set(std::string_view argument, Fields fields) { structs_[std::string(argument)] = std::move(fields); }
  void set(std::string_view argument, Table table) { tables_[std::string(argument)] = std::move(table); }

  /// The numbers of a pass's parameter structs, for a grid of this shape.
  std::vector<double> parameters(const PassInfo& pass, Shape shape) const;
  /// Its tables: what was set, else the output of that name of one of the model's passes, which is run if need be.
  std::vector<Table> inputs(const PassInfo& pass) const;

  /// One of a pass's tables.
  Table table(std::string_view argument, const PassInfo& reader) const;

  /// Runs a pass; the result is kept by the engine.
  std::vector<Table> run(std::string_view pass, Shape shape) const;
  /// Runs a pass over questions that will not be asked again.
  std::vector<Table> run_once(std::string_view pass, Shape shape) const;

  /// The same, of a pass whose shape decides on its own.
  std::vector<Table> run_once(const TablePass& made) const { return run_once(made.pass, made.shape_for(situation_)); }

  Engine& engine() const { return engine_; }

 private:
  std::vector<Table> run(const TablePass& made) const;
  std::vector<Table> orders() const;  // what Model::orders sums up to, kept by the engine

  Engine& engine_;
  const Model& model_;
  Situation situation_;
  std::map<std::string, Fields, std::less<>> structs_;
  std::map<std::string, Table, std::less<>> tables_;
  HostTables* host_tables_ = nullptr;
};

}  // namespace airlight
