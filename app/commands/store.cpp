#include <memory>

#include <fmt/format.h>

#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/output/phrases.h"
#include "app/store/prune.h"
#include "app/store/stored_text.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

struct StoreArguments {
  std::string out, store;
  std::vector<std::string> shards;
  bool quiet = false, dry_run = false;
};

Expected<int> merge_and_tell(const StoreArguments& arguments) {
  auto out = Store::open(arguments.out, Database::Access::Write);
  if (!out) {
    return tl::unexpected(out.error());
  }
  for (const std::string& name : arguments.shards) {
    auto shard = Store::open(name, Database::Access::Read);
    if (!shard) {
      return tl::unexpected(shard.error());
    }
    if (auto merged = out->merge(*shard); !merged) {
      return tl::unexpected(merged.error());
    }
  }
  if (!arguments.quiet) {
    fmt::print("{} stores were merged into {}.\n", arguments.shards.size(), out->name());
  }
  return 0;
}

Expected<int> dump(const StoreArguments& arguments) {
  auto store = Store::open(arguments.store, Database::Access::Read);
  if (!store) {
    return tl::unexpected(store.error());
  }
  auto dumped = store->dump([](std::string_view line) { fmt::print("{}", line); });
  return dumped.map([] { return 0; });
}

std::string line_of(const VanishedFile& file) {
  return fmt::format("  {}{}\n", in_one_line(file.path),
                     !file.now_at.empty() ? fmt::format(", now {}", in_one_line(file.now_at))
                     : file.name.empty()  ? ", could not be read"
                                          : fmt::format(", {}", in_quotes(file.name)));
}

Expected<int> prune(const StoreArguments& arguments) {
  auto store = Store::open(arguments.store, arguments.dry_run ? Database::Access::Read : Database::Access::Write);
  if (!store) {
    return tl::unexpected(store.error());
  }
  const auto gone = vanished_files(*store);
  if (!gone) {
    return tl::unexpected(gone.error());
  }
  if (auto removed = arguments.dry_run ? Expected<void>() : remove_files(*store, *gone); !removed) {
    return tl::unexpected(removed.error());
  }
  if (!arguments.quiet) {
    fmt::print("{} of {} at which no file is any more{}\n", plural(gone->size(), "path"), store->name(),
               gone->empty()       ? "."
               : arguments.dry_run ? " would be removed:"
                                   : " were removed; their results stay:");
    for (const VanishedFile& file : *gone) {
      fmt::print("{}", line_of(file));
    }
  }
  return 0;
}

}  // namespace

Run set_up_store(CLI::App& parser) {
  auto arguments = std::make_shared<StoreArguments>();
  parser.require_subcommand(1);
  CLI::App* merge =
      parser.add_subcommand("merge", "add what other stores hold to a store; the same again changes nothing");
  merge->add_option("out", arguments->out, "store to add to; made where it is not there")->required()->type_name("OUT");
  merge->add_option("shards", arguments->shards, "stores to read")->required()->type_name("STORE…");
  merge->add_flag("--quiet,-q", arguments->quiet, "print nothing but errors");
  CLI::App* dumped =
      parser.add_subcommand("dump", "print all results, a row a line; the same results give the same bytes");
  dumped->add_option("store", arguments->store, "file or postgresql://…")->required()->type_name("STORE");
  CLI::App* pruned = parser.add_subcommand("prune", "remove paths of recordings that were moved or deleted");
  pruned->add_option("store", arguments->store, "file or postgresql://…")->required()->type_name("STORE");
  pruned->add_flag("--dry-run", arguments->dry_run, "list them, remove nothing");
  pruned->add_flag("--quiet,-q", arguments->quiet, "print nothing but errors");
  pruned->footer(
      "Run it on the computer that has the files. The results themselves stay, so that those that rest on a "
      "certificate "
      "can still be found.\nExample:\n  artcal store prune all.sqlite --dry-run");
  parser.footer("Examples:\n  artcal store merge all.sqlite shard-*.sqlite\n  artcal store dump all.sqlite");
  return [arguments, merge, pruned] {
    const auto done = merge->parsed()    ? merge_and_tell(*arguments)
                      : pruned->parsed() ? prune(*arguments)
                                         : dump(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
