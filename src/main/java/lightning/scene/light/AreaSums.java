package lightning.scene.light;

import java.util.Arrays;

/**
 * Parts of a surface, one of which is chosen in proportion to its area.
 *
 * @param sums sums of the areas of parts up to and including each, {@code double[parts]}
 */
record AreaSums(double[] sums) {
    /**
     * Part and place in it.
     *
     * @param index index of the part
     * @param share share of the area of the part that comes before the place, 0…1
     */
    record Place(int index, double share) {}

    /** Returns the area of all parts. */
    double total() {
        return sums.length == 0 ? 0 : sums[sums.length - 1];
    }

    /** Returns the place that has a share of the whole area before it, 0…1, in a part that has an area. */
    Place at(double share) {
        double value = share * total();
        int index = indexOf(value);
        double before = index == 0 ? 0 : sums[index - 1];
        return new Place(index, Math.clamp((value - before) / (sums[index] - before), 0, 1));
    }

    /** Returns the first index whose sum is above a value; the last with an area of its own if there is none. */
    private int indexOf(double value) {
        int found = Arrays.binarySearch(sums, value);
        int index = found >= 0 ? found + 1 : -found - 1;
        while (index < sums.length && sums[index] == value) {
            index++;
        }
        index = Math.min(index, sums.length - 1);
        while (index > 0 && sums[index] == sums[index - 1]) {
            index--;
        }
        return index;
    }
}
