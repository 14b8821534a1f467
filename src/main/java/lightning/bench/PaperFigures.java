package lightning.bench;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.scene.paper.PaperCase;

/** Mapping from the paper's figures to their edits: an image figure is followed by a timing figure. */
public final class PaperFigures {
    /** Timing figures, each with its image figure. */
    private static final Map<Integer, Integer> PICTURE_FIGURES = new TreeMap<>(Map.of(7, 6, 9, 8, 11, 10, 14, 13, 16, 15, 18, 17, 20, 19,
            22, 21, 23, 23, 25, 24));
    /** Figure of all edits with updated reflections. */
    private static final int ALL_EDITS = 26;
    private static final String BIRD = "bird";
    /** Appendix B of the paper: all of its edits on four further scenes, in its order. */
    private static final List<String> APPENDIX = List.of("balls", "spaceship", "desk", "house");
    private static final Pattern EXAMPLE = Pattern.compile("[Bb]([1-4])?");
    private static final Pattern NUMBER = Pattern.compile("[0-9]{1,2}");

    /**
     * Edits and scenes of a figure.
     *
     * @param figure number of the paper's figure with these edits
     * @param scenes names of its scenes
     */
    public record Subject(int figure, List<String> scenes) {
        public Subject {
            scenes = List.copyOf(scenes);
        }
    }

    private PaperFigures() {}

    /**
     * Parses a figure's name: its number, {@code B1} to {@code B4} for an example of Appendix B, or {@code B} for all four.
     *
     * @return empty if the figure has no measured edits
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

    /** Returns whether a figure has measured edits. */
    static boolean isMeasured(int figure) {
        return figure == ALL_EDITS || PICTURE_FIGURES.containsKey(figure) || PICTURE_FIGURES.containsValue(figure);
    }

    /** Returns the figures with measured edits, as text for a sentence. */
    public static String measuredRange() {
        return "6 to 11, 13 to 26, B1 to B4 or B for Appendix B";
    }

    /** Returns whether a figure includes a case. */
    static boolean shows(int figure, PaperCase edit) {
        return figure == ALL_EDITS ? edit.isPrinted() : edit.figure().equals("Fig. " + PICTURE_FIGURES.getOrDefault(figure, figure));
    }
}
