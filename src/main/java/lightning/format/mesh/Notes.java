package lightning.format.mesh;

import java.util.LinkedHashMap;
import java.util.Map;
import lightning.base.text.Visible;

/** What a file holds that was left out, counted by its kind, so that nothing is dropped in silence. */
public final class Notes {
    /** So many kinds are told apart: a file may invent as many as it has bytes. */
    private static final int MOST = 100;
    private static final String REST = "others";

    private final Map<String, Integer> counts = new LinkedHashMap<>();

    /** One more of a kind, named in the plural. */
    public void add(String kind) {
        add(kind, 1);
    }

    public void add(String kind, int count) {
        if (count > 0) {
            String shown = Visible.escaped(kind);
            counts.merge(counts.size() < MOST || counts.containsKey(shown) ? shown : REST, count, Integer::sum);
        }
    }

    /** How many of each kind, named in one line, in the order in which they were found. */
    public Map<String, Integer> counts() {
        return counts;
    }
}
