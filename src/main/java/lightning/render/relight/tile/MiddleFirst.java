package lightning.render.relight.tile;

import java.util.Comparator;
import java.util.stream.IntStream;

/** The order in which tiles are traced where somebody may watch: from the middle of the picture outwards. */
final class MiddleFirst {
    private MiddleFirst() {}

    /**
     * The numbers of all tiles, those nearest to the middle first.
     *
     * @param across how many tiles a row has
     * @param count  how many there are, whole rows
     */
    static int[] order(int across, int count) {
        int down = count / across;
        return IntStream.range(0, count).boxed().sorted(Comparator.comparingInt(tile -> fromMiddle(tile % across, across)
                + fromMiddle(tile / across, down))).mapToInt(Integer::intValue).toArray();
    }

    /** The square of a distance along one side, in half tiles. */
    private static int fromMiddle(int at, int count) {
        int distance = 2 * at + 1 - count;
        return distance * distance;
    }
}
