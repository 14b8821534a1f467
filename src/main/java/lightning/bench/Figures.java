package lightning.bench;

import java.util.Map;
import java.util.TreeMap;
import lightning.accuracy.PaperCase;

/** Which edits the paper's figures are about: a figure of pictures is followed by one of times. */
public final class Figures {
    /** A figure of times, and the one of the pictures that it is about. */
    private static final Map<Integer, Integer> PICTURES = new TreeMap<>(Map.of(7, 6, 9, 8, 11, 10, 14, 13, 16, 15, 18, 17, 20, 19,
            22, 21, 23, 23, 25, 24));
    /** All edits, reflections updated. */
    private static final int ALL = 26;

    private Figures() {}

    /** Whether a figure shows measured edits. */
    public static boolean isMeasured(int figure) {
        return figure == ALL || PICTURES.containsKey(figure) || PICTURES.containsValue(figure);
    }

    /** Which figures show measured edits, for a sentence. */
    public static String measured() {
        return "6 to 11, 13 to 26";
    }

    /** Whether a figure is about a case. */
    static boolean shows(int figure, PaperCase edit) {
        return figure == ALL ? edit.isPrinted() : edit.figure().equals("Fig. " + PICTURES.getOrDefault(figure, figure));
    }
}
