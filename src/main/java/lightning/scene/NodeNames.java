package lightning.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import lightning.base.text.Quote;

/** The names of shapes and groups, each of which one has, sorted: a table of hashes would be slow where a file chose names that collide. */
final class NodeNames {
    /** More names are not exchanged one by one. */
    private static final int FEW = 64;

    private final List<String> sorted;

    private NodeNames(List<String> sorted) {
        this.sorted = sorted;
    }

    /**
     * Names in any order.
     *
     * @throws IllegalArgumentException if two are the same
     */
    static NodeNames of(List<String> names) {
        String[] sorted = names.toArray(String[]::new);
        Arrays.parallelSort(sorted);
        for (int i = 1; i < sorted.length; i++) {
            if (sorted[i].equals(sorted[i - 1])) {
                throw taken(sorted[i]);
            }
        }
        return new NodeNames(BlockList.copyOf(Arrays.asList(sorted)));
    }

    int count() {
        return sorted.size();
    }

    boolean contains(String name) {
        return place(sorted, name) >= 0;
    }

    private static int place(List<String> names, String name) {
        return Collections.binarySearch(names, name);
    }

    /**
     * These names without some that are among them, and with others; themselves where both are the same.
     *
     * @throws IllegalArgumentException if two are the same then
     */
    NodeNames replacing(List<String> gone, List<String> came) {
        if (gone.equals(came)) {
            return this;
        }
        return gone.size() + came.size() > FEW ? allReplacing(gone, came) : new NodeNames(eachReplacing(gone, came));
    }

    private NodeNames allReplacing(List<String> gone, List<String> came) {
        List<String> names = new ArrayList<>(sorted);
        names.removeIf(new HashSet<>(gone)::contains);
        names.addAll(came);
        return of(names);
    }

    private List<String> eachReplacing(List<String> gone, List<String> came) {
        List<String> names = sorted;
        for (String name : gone) {
            int place = place(names, name);
            names = BlockList.spliced(names, place, place + 1, List.of());
        }
        for (String name : came) {
            int place = place(names, name);
            if (place >= 0) {
                throw taken(name);
            }
            names = BlockList.spliced(names, -place - 1, -place - 1, List.of(name));
        }
        return names;
    }

    private static IllegalArgumentException taken(String name) {
        return new IllegalArgumentException("shape " + Quote.of(name) + ": the name is already taken");
    }
}
