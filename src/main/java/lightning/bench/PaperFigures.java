package lightning.bench;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.bench.accuracy.PaperCase;

/** Which edits the paper's figures are about: a figure of pictures is followed by one of times. */
public final class PaperFigures {
    /** A figure of times, and the one of the pictures that it is about. */
    private static final Map<Integer, Integer> PICTURE_FIGURES = new TreeMap<>(Map.of(7, 6, 9, 8, 11, 10, 14, 13, 16, 15, 18, 17, 20, 19,
            22, 21, 23, 23, 25, 24));
    /** All edits, reflections updated. */
    private static final int ALL_EDITS = 26;
    private static final String BIRD = "bird";
    /** The paper's Appendix B: all edits of its body on four further scenes, in its order. */
    private static final List<String> APPENDIX = List.of("balls", "spaceship", "desk", "house");
    private static final Pattern EXAMPLE = Pattern.compile("[Bb]([1-4])?");
    private static final Pattern NUMBER = Pattern.compile("[0-9]{1,2}");

    /**
     * What a figure is about.
     *
     * @param figure the number of the paper's figure that shows its edits
     * @param scenes the names of its scenes
     */
    public record Subject(int figure, List<String> scenes) {
        public Subject {
            scenes = List.copyOf(scenes);
        }
    }

    private PaperFigures() {}

    /**
     * Reads a figure's name: its number, or {@code B1} to {@code B4} for an example of Appendix B, {@code B} for all four.
     *
     * @return empty where it shows no measured edits
     */
    public static Optional<Subject> parse(String name) {
        Matcher example = EXAMPLE.matcher(name);
        if (example.matches()) {
            return Optional.of(new Subject(ALL_EDITS, example.group(1) == null ? APPENDIX
                    : List.of(APPENDIX.get(Integer.parseInt(example.group(1)) - 1))));
        }
        return NUMBER.matcher(name).matches() && isMeasured(Integer.parseInt(name))
                ? Optional.of(new Subject(Integer.parseInt(name), List.of(BIRD))) : Optional.empty();
    }

    /** Whether a figure shows measured edits. */
    static boolean isMeasured(int figure) {
        return figure == ALL_EDITS || PICTURE_FIGURES.containsKey(figure) || PICTURE_FIGURES.containsValue(figure);
    }

    /** Which figures show measured edits, for a sentence. */
    public static String measuredRange() {
        return "6 to 11, 13 to 26, B1 to B4 or B for Appendix B";
    }

    /** Whether a figure is about a case. */
    static boolean shows(int figure, PaperCase edit) {
        return figure == ALL_EDITS ? edit.isPrinted() : edit.figure().equals("Fig. " + PICTURE_FIGURES.getOrDefault(figure, figure));
    }
}
