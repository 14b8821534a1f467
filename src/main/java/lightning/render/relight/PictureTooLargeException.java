package lightning.render.relight;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import lightning.scene.IndirectSettings;

/**
 * Reports a picture that does not fit into its memory limit. The message is a sentence without a period that suggests what would
 * fit. It omits the storage of mirrors, which not every caller can choose.
 */
public final class PictureTooLargeException extends RuntimeException {
    private static final long serialVersionUID = 1;
    private static final double GB = 1e9;
    /** Share of indirect light from which the message names it. */
    private static final double MIN_SHOWN_SHARE = 0.1;

    private final long requiredBytes;
    private final long availableBytes;
    private final long indirectBytes;
    private final transient List<Suggestion> suggestions;

    /** Change of the picture that would fit. */
    public sealed interface Suggestion {
        record Size(int width, int height) implements Suggestion {}

        /** Samples along each side of a pixel. */
        record Samples(int grid) implements Suggestion {}

        record NoAntialias() implements Suggestion {}

        /** Store only the hit shapes of mirror levels. */
        record MirrorsAsShapes() implements Suggestion {}

        /** Settings with fewer paths of indirect light. */
        record Paths(IndirectSettings settings) implements Suggestion {}

        /** Returns the phrase after "it would fit with". */
        default String description() {
            return switch (this) {
                case Size size -> "a size of " + size.width + "x" + size.height;
                case Samples samples -> samples.grid + "x" + samples.grid + " samples";
                case NoAntialias _ -> "no anti-aliasing";
                case MirrorsAsShapes _ -> "mirrors stored as shapes";
                case Paths paths -> "indirect light of " + paths.settings.label();
            };
        }
    }

    /**
     * @param required    bytes
     * @param available   bytes
     * @param indirect    bytes of the paths of indirect light in those required, 0 if unknown
     * @param suggestions changes that would fit; empty if nothing fits
     */
    PictureTooLargeException(long required, long available, long indirect, List<Suggestion> suggestions) {
        super(text(required, available, indirect, suggestions,
                suggestion -> suggestion instanceof Suggestion.MirrorsAsShapes ? Optional.empty() : Optional.of(suggestion.description())));
        this.requiredBytes = required;
        this.availableBytes = available;
        indirectBytes = indirect;
        this.suggestions = List.copyOf(suggestions);
    }

    /**
     * Returns the message with suggestions in the caller's words.
     *
     * @param describer phrase of a suggestion; empty if the caller does not offer it
     */
    public String message(Function<Suggestion, Optional<String>> describer) {
        return text(requiredBytes, availableBytes, indirectBytes, suggestions, describer);
    }

    private static String text(long required, long available, long indirect, List<Suggestion> suggestions,
            Function<Suggestion, Optional<String>> describer) {
        String fitting =
                suggestions.stream().flatMap(suggestion -> describer.apply(suggestion).stream()).collect(Collectors.joining(", or with "));
        return String.format(Locale.ROOT, "the picture needs about %.1f GB of memory%s, and %.1f GB is available; %s", required / GB,
                indirect < MIN_SHOWN_SHARE * required ? ""
                        : String.format(Locale.ROOT, ", %.1f GB of it for indirect light", indirect / GB),
                Math.max(available, 0) / GB, fitting.isEmpty() ? "it would not fit at any size" : "it would fit with " + fitting);
    }
}
