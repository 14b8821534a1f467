package lightning.scene.asset;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * Continuation of an image beyond its edges.
 *
 * @param u left and right of it
 * @param v above and below it
 */
public record TextureWrap(Edge u, Edge v) {
    /** The image repeats endlessly. */
    public static final TextureWrap REPEAT = new TextureWrap(Edge.REPEAT, Edge.REPEAT);
    /** The pixels of the edges are repeated. */
    public static final TextureWrap CLAMP = new TextureWrap(Edge.CLAMP, Edge.CLAMP);

    /** All values, those of one kind of edge first. */
    public static final List<TextureWrap> ALL = Stream.of(true, false).flatMap(isSame -> Stream.of(Edge.values())
            .flatMap(u -> Stream.of(Edge.values()).filter(v -> (u == v) == isSame).map(v -> new TextureWrap(u, v)))).toList();

    /** Continuation at an edge. */
    public enum Edge {
        /** The image again. */
        REPEAT,
        /** The pixel at the edge. */
        CLAMP,
        /** The image, mirrored each second time. */
        MIRROR;

        private String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /** Returns the keyword in files: one word if both edges are of one kind. */
    public String word() {
        return u == v ? u.word() : u.word() + "_" + v.word();
    }
}
