package lightning.format.exchange.usd;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import lightning.format.usd.UsdStage;

/**
 * Image files of a texture, placed in a grid that repeats. A texture of one file has one tile. Tile {@code 1001 + u + 10 v} (UDIM) covers
 * texture coordinates from (u, v); in a grid of n columns it is in column {@code u mod n}, so that coordinates divided by n find it without
 * an offset.
 *
 * @param tiles existing tiles, at least one
 */
record UsdTiles(List<Tile> tiles, int columns, int rows, boolean isSingle) {
    private static final int FIRST = 1001;
    private static final int COLUMNS = 10;
    private static final int MAX_TILE = 9999;

    /**
     * An image file.
     *
     * @param row counted from the top
     */
    record Tile(Path place, int column, int row) {}

    /** Returns the files of a texture; empty if none exists. */
    static Optional<UsdTiles> of(JsonValue image) throws MeshException {
        JsonValue all = image.get("tiles");
        if (!all.isPresent()) {
            return UsdStage.place(image).map(place -> new UsdTiles(List.of(new Tile(place, 0, 0)), 1, 1, true));
        }
        List<Tile> found = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            int index = all.element(i).get("tile").integer(FIRST, MAX_TILE) - FIRST;
            UsdStage.place(all.element(i)).ifPresent(place -> found.add(new Tile(place, index % COLUMNS, index / COLUMNS)));
        }
        if (found.isEmpty()) {
            return Optional.empty();
        }
        int columns =
                1 + found.stream().mapToInt(Tile::column).max().orElseThrow() - found.stream().mapToInt(Tile::column).min().orElseThrow();
        int rows = 1 + found.stream().mapToInt(Tile::row).max().orElseThrow() - found.stream().mapToInt(Tile::row).min().orElseThrow();
        return Optional.of(new UsdTiles(found.stream()
                .map(tile -> new Tile(tile.place(), tile.column() % columns, rows - 1 - tile.row() % rows)).toList(), columns, rows,
                false));
    }

    /** Returns a text that is equal for equal files. */
    String key() {
        return tiles.toString();
    }
}
