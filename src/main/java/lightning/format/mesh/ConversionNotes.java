package lightning.format.mesh;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.base.text.PrintableText;
import lightning.base.text.Quote;

/** Counts of omitted or approximated features by kind, so that nothing is dropped silently. */
public final class ConversionNotes {
    /** Maximum number of kinds, since a file may contain arbitrarily many. */
    private static final int MAX_KINDS = 100;
    private static final String OTHER_KINDS = "others";

    private final Map<String, Integer> counts = new LinkedHashMap<>();
    /** Names of what has the features of a kind. */
    private final Map<String, Set<String>> names = new LinkedHashMap<>();

    /** Counts one feature of a kind, named in the plural. */
    public void add(String kind) {
        add(kind, 1);
    }

    public void add(String kind, int count) {
        if (count > 0) {
            String printable = PrintableText.escape(kind);
            counts.merge(counts.size() < MAX_KINDS || counts.containsKey(printable) ? printable : OTHER_KINDS, count, Integer::sum);
        }
    }

    /** Counts one feature of a kind, and lists what has it. */
    public void addNamed(String kind, String name) {
        names.computeIfAbsent(kind, _ -> new LinkedHashSet<>()).add(name);
    }

    /** Returns the count of each kind, with one-line names: in order of first occurrence, and those with lists last. */
    public Map<String, Integer> counts() {
        Map<String, Integer> all = new LinkedHashMap<>(counts);
        names.forEach((kind, list) -> all.put(kind + ": " + Quote.list(List.copyOf(list)), list.size()));
        return all;
    }
}
