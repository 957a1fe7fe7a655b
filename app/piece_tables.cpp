#include "app/piece_tables.h"

#include "ui/packing.h"
#include "ui/revisions.h"

#include <algorithm>

namespace splineloft::app {

const gl::TexelRow& PieceTables::upToDate(const ui::PieceTable& table) {
    const auto& revisions = *table.revisions;
    auto found = copies_.find(revisions.identity());
    if (found == copies_.end()) {
        found =
            copies_.emplace(revisions.identity(), Copy{gl::TexelRow(table.points.size())}).first;
    }
    auto& copy = found->second;
    for (const auto& blocks : revisions.since(copy.revision)) {
        const auto points = ui::pointsOf(table, blocks);
        copy.texels.upload(points.first,
                           ui::packed(table.points.subspan(points.first, points.size())));
    }
    copy.revision = revisions.revision();
    copy.isUsed = true;
    return copy.texels;
}

void PieceTables::forgetUnused() {
    std::erase_if(copies_, [](const auto& entry) { return !entry.second.isUsed; });
    for (auto& [identity, copy] : copies_) {
        copy.isUsed = false;
    }
}

} // namespace splineloft::app
