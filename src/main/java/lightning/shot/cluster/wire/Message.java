package lightning.shot.cluster.wire;

import java.util.UUID;

/**
 * What a member says to another. A coordinator asks, a node answers; any message may come twice, and any may be asked for again: what is
 * lost on the way costs time alone.
 *
 * <p>A session is one node's frames for one coordinator; a call is one wish within it, and names the film that came of it.
 */
public sealed interface Message {
    /** Bytes of a message, at most. */
    int MOST_BYTES = 1 << 21;
    /** Bytes of content that one message carries, at most. */
    int PART_BYTES = 1 << 20;
    /** Bytes of a sentence, in UTF-8. */
    int TEXT_BYTES = 3000;

    UUID session();

    /** A coordinator opens a session. */
    record Hello(UUID session, String release) implements Message {}

    /** A node is there for it. @param memory bytes that it may take for frames */
    record Ready(UUID session, String release, int threads, long memory) implements Message {}

    /** Wants a frame to show a take, which a bill tells. @param billBytes the length of the bill */
    record Bring(UUID session, long call, int frame, Hash bill, int billBytes) implements Message {}

    /**
     * The frame shows it.
     *
     * @param memory bytes that frames of the session take in memory
     * @param disk   and on disk
     */
    record Brought(UUID session, long call, boolean traced, String plan, long rays, long nanoseconds, int width, int height, long memory,
            long disk) implements Message {}

    /** The frame does not. */
    record Failed(UUID session, long call, Reason reason, String sentence) implements Message {}

    /** Why a frame was not brought to a take. */
    enum Reason {
        /** It was asked to stop. */
        CANCELLED,
        /** The take has no such frame, or is none. */
        UNUSABLE,
        /** This node has no room for it, or for what it needs; another may. */
        REFUSED,
        /** An error of the program. */
        ERROR
    }

    /** Wants no more that a frame is brought. */
    record Cancel(UUID session, long call) implements Message {}

    /** Asks for content. */
    record Need(UUID session, Hash hash, long offset) implements Message {}

    /** Some of the content, at most {@link #PART_BYTES}; empty at its end, and where there is none such. */
    record Part(UUID session, Hash hash, long offset, byte[] bytes) implements Message {}

    /**
     * Asks for tiles of the film that a call made, made smaller so as to have room.
     *
     * @param mostWidth pixels; likewise {@code mostHeight}
     */
    record Ask(UUID session, long call, int frame, int mostWidth, int mostHeight, int firstTile, int tiles) implements Message {}

    /** Tiles of that film: of each all red, all green, all blue, floats with their highest byte first. */
    record Pixels(UUID session, long call, int frame, int mostWidth, int mostHeight, int firstTile, byte[] bytes) implements Message {}

    /** The film of that call is there no more. */
    record Gone(UUID session, long call, int frame) implements Message {}

    /** Tells which frame is looked at. */
    record Focus(UUID session, int frame) implements Message {}

    /** Wants a frame to be dropped. */
    record Forget(UUID session, int frame) implements Message {}

    /** Asks whether a node still has a session; it says the same, or that the session has ended. */
    record Alive(UUID session) implements Message {}

    /** Ends a session; of a node, that it has none such. */
    record End(UUID session) implements Message {}
}
