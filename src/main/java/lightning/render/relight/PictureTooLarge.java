package lightning.render.relight;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * A picture does not fit into the memory that it may take. The message is a sentence without its full stop that says what would
 * fit, for somebody who cannot choose how mirrors are kept.
 */
public final class PictureTooLarge extends RuntimeException {
    private static final long serialVersionUID = 1;
    private static final double GB = 1e9;

    private final long need;
    private final long available;
    private final transient List<Way> ways;

    /** What of the picture would fit. */
    public sealed interface Way {
        record Size(int width, int height) implements Way {}

        /** So many along each side of a pixel. */
        record Samples(int grid) implements Way {}

        record NoAntialias() implements Way {}

        /** Of mirror levels only the shapes that rays hit. */
        record Shapes() implements Way {}

        /** As in "it would fit with …". */
        default String text() {
            return switch (this) {
                case Size size -> "a size of " + size.width + "x" + size.height;
                case Samples samples -> samples.grid + "x" + samples.grid + " samples";
                case NoAntialias _ -> "no anti-aliasing";
                case Shapes _ -> "mirrors kept as shapes";
            };
        }
    }

    /**
     * @param need      bytes
     * @param available bytes
     * @param ways      what would fit; none where nothing would
     */
    PictureTooLarge(long need, long available, List<Way> ways) {
        super(text(need, available, ways, way -> way instanceof Way.Shapes ? Optional.empty() : Optional.of(way.text())));
        this.need = need;
        this.available = available;
        this.ways = List.copyOf(ways);
    }

    /**
     * The message in the words of whoever asked.
     *
     * @param words for a way out; empty where it cannot be taken there
     */
    public String message(Function<Way, Optional<String>> words) {
        return text(need, available, ways, words);
    }

    private static String text(long need, long available, List<Way> ways, Function<Way, Optional<String>> words) {
        String fitting = ways.stream().flatMap(way -> words.apply(way).stream()).collect(Collectors.joining(", or with "));
        return String.format(Locale.ROOT, "the picture needs about %.1f GB of memory and may have %.1f GB; %s", need / GB,
                Math.max(available, 0) / GB, fitting.isEmpty() ? "no part of it would fit" : "it would fit with " + fitting);
    }
}
