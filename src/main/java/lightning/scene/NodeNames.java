package lightning.scene;

import java.util.Arrays;
import java.util.List;
import lightning.text.Quote;

/** The names of shapes and groups, each of which one has, sorted: a table of hashes would be slow where a file chose names that collide. */
final class NodeNames {
    private final String[] sorted;

    private NodeNames(String[] sorted) {
        this.sorted = sorted;
    }

    /**
     * Names in any order.
     *
     * @throws IllegalArgumentException if two are the same
     */
    static NodeNames of(List<String> names) {
        String[] sorted = sorted(names);
        for (int i = 1; i < sorted.length; i++) {
            if (sorted[i].equals(sorted[i - 1])) {
                throw taken(sorted[i]);
            }
        }
        return new NodeNames(sorted);
    }

    private static String[] sorted(List<String> names) {
        String[] all = names.toArray(String[]::new);
        Arrays.parallelSort(all);
        return all;
    }

    int count() {
        return sorted.length;
    }

    boolean contains(String name) {
        return Arrays.binarySearch(sorted, name) >= 0;
    }

    /**
     * These names without some of them and with others; themselves where both are the same.
     *
     * @throws IllegalArgumentException if two are the same then
     */
    NodeNames replacing(List<String> gone, List<String> came) {
        return gone.equals(came) ? this : new NodeNames(merged(sorted, sorted(gone), sorted(came)));
    }

    private static String[] merged(String[] names, String[] gone, String[] came) {
        String[] all = new String[names.length - gone.length + came.length];
        int from = 0;
        int to = 0;
        int g = 0;
        int c = 0;
        while (g < gone.length || c < came.length) {
            // What goes first, so that a name that comes again is not found any more.
            boolean goes = c == came.length || g < gone.length && gone[g].compareTo(came[c]) <= 0;
            int found = Arrays.binarySearch(names, from, names.length, goes ? gone[g] : came[c]);
            int place = found < 0 ? -found - 1 : found;
            System.arraycopy(names, from, all, to, place - from);
            to += place - from;
            from = place;
            if (goes) {
                from++;
                g++;
            } else if (found >= 0 || c > 0 && came[c].equals(came[c - 1])) {
                throw taken(came[c]);
            } else {
                all[to++] = came[c++];
            }
        }
        System.arraycopy(names, from, all, to, names.length - from);
        return all;
    }

    private static IllegalArgumentException taken(String name) {
        return new IllegalArgumentException("shape " + Quote.of(name) + ": the name is already taken");
    }
}
