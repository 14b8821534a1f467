package lightning.format.mesh;

import java.util.Arrays;

/**
 * Numbers corners: two corners of the same three keys are one vertex. A table with open places (Knuth, The Art of Computer
 * Programming 3, §6.4, algorithm L), since ten million corners as objects would take a gigabyte.
 */
public final class CornerTable {
    private static final int KEYS = 3;

    private final IntList keys = new IntList();
    private int[] places = new int[64];

    public CornerTable() {
        Arrays.fill(places, -1);
    }

    public int size() {
        return keys.size() / KEYS;
    }

    /** A key of a corner. */
    public int key(int corner, int which) {
        return keys.get(KEYS * corner + which);
    }

    /** The number of a corner, from 0 in the order of their coming. */
    public int number(int a, int b, int c) {
        int mask = places.length - 1;
        int place = hash(a, b, c) & mask;
        while (places[place] >= 0) {
            int corner = places[place];
            if (key(corner, 0) == a && key(corner, 1) == b && key(corner, 2) == c) {
                return corner;
            }
            place = place + 1 & mask;
        }
        places[place] = size();
        keys.add(a);
        keys.add(b);
        keys.add(c);
        if (2 * size() > places.length) {
            grow();
        }
        return size() - 1;
    }

    private void grow() {
        places = new int[2 * places.length];
        Arrays.fill(places, -1);
        int mask = places.length - 1;
        for (int corner = 0; corner < size(); corner++) {
            int place = hash(key(corner, 0), key(corner, 1), key(corner, 2)) & mask;
            while (places[place] >= 0) {
                place = place + 1 & mask;
            }
            places[place] = corner;
        }
    }

    /** Mixed as in SplitMix64 (Steele, Lea and Flood, Fast splittable pseudorandom number generators, 2014). */
    private static int hash(int a, int b, int c) {
        long h = a * 0x9E3779B97F4A7C15L + b;
        h = (h ^ h >>> 30) * 0xBF58476D1CE4E5B9L + c;
        h = (h ^ h >>> 27) * 0x94D049BB133111EBL;
        return (int) (h ^ h >>> 31);
    }
}
