package lightning.render.relight.tile;

import java.util.Comparator;
import java.util.stream.IntStream;

/** Order in which tiles are traced for display: from the center of the picture outwards. */
final class CenterFirstOrder {
    private CenterFirstOrder() {}

    /**
     * Returns the numbers of all tiles, those nearest to the center first.
     *
     * @param tilesPerRow number of tiles in a row
     * @param count       number of tiles, whole rows
     */
    static int[] tileOrder(int tilesPerRow, int count) {
        int tileRows = count / tilesPerRow;
        return IntStream.range(0, count).boxed().sorted(Comparator.comparingInt(tile -> squaredDistance(tile % tilesPerRow, tilesPerRow)
                + squaredDistance(tile / tilesPerRow, tileRows))).mapToInt(Integer::intValue).toArray();
    }

    /** Returns the square of a distance along one side, in half tiles. */
    private static int squaredDistance(int at, int count) {
        int distance = 2 * at + 1 - count;
        return distance * distance;
    }
}
