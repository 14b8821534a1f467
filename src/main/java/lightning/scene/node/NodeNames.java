package lightning.scene.node;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;

/** Sorted table of the names of shapes and groups. Sorted rather than hashed, because a file could choose names whose hashes collide. */
public record NodeNames(List<String> sorted) {
    /** Maximum number of names replaced one by one. */
    private static final int MAX_INCREMENTAL = 64;

    /**
     * Creates a table from names in any order.
     *
     * @throws IllegalArgumentException if two are equal
     */
    static NodeNames of(List<String> names) {
        String[] sorted = names.toArray(String[]::new);
        Arrays.parallelSort(sorted);
        for (int i = 1; i < sorted.length; i++) {
            if (sorted[i].equals(sorted[i - 1])) {
                throw duplicateName(sorted[i]);
            }
        }
        return new NodeNames(BlockList.copyOf(Arrays.asList(sorted)));
    }

    int count() {
        return sorted.size();
    }

    public boolean contains(String name) {
        return indexOf(sorted, name) >= 0;
    }

    private static int indexOf(List<String> names, String name) {
        return Collections.binarySearch(names, name);
    }

    /**
     * Returns this table without some of its names and with others; itself if both lists are equal.
     *
     * @throws IllegalArgumentException if two names are then equal
     */
    NodeNames replace(List<String> removed, List<String> added) {
        if (removed.equals(added)) {
            return this;
        }
        return removed.size() + added.size() > MAX_INCREMENTAL ? replaceAll(removed, added) : new NodeNames(replaceEach(removed, added));
    }

    private NodeNames replaceAll(List<String> removed, List<String> added) {
        List<String> names = new ArrayList<>(sorted);
        names.removeIf(new HashSet<>(removed)::contains);
        names.addAll(added);
        return of(names);
    }

    private List<String> replaceEach(List<String> removed, List<String> added) {
        List<String> names = sorted;
        for (String name : removed) {
            int index = indexOf(names, name);
            names = BlockList.splice(names, index, index + 1, List.of());
        }
        for (String name : added) {
            int index = indexOf(names, name);
            if (index >= 0) {
                throw duplicateName(name);
            }
            names = BlockList.splice(names, -index - 1, -index - 1, List.of(name));
        }
        return names;
    }

    private static IllegalArgumentException duplicateName(String name) {
        return new RefusalException("object " + Quote.of(name) + ": the name is already taken");
    }
}
