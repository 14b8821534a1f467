package lightning.render.relight.tile;

import java.util.Comparator;
import java.util.stream.IntStream;

/** The order in which tiles are traced where somebody may watch: from the middle of the picture outwards. */
final class CenterFirstOrder {
    private CenterFirstOrder() {}

    /**
     * The numbers of all tiles, those nearest to the middle first.
     *
     * @param tilesPerRow how many tiles a row has
     * @param count  how many there are, whole rows
     */
    static int[] tileOrder(int tilesPerRow, int count) {
        int tileRows = count / tilesPerRow;
        return IntStream.range(0, count).boxed().sorted(Comparator.comparingInt(tile -> squaredDistance(tile % tilesPerRow, tilesPerRow)
                + squaredDistance(tile / tilesPerRow, tileRows))).mapToInt(Integer::intValue).toArray();
    }

    /** The square of a distance along one side, in half tiles. */
    private static int squaredDistance(int at, int count) {
        int distance = 2 * at + 1 - count;
        return distance * distance;
    }
}
