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
    int MAX_BYTES = 1 << 21;
    /** Bytes of content that one message carries, at most. */
    int PART_BYTES = 1 << 20;
    /** Bytes of a sentence, in UTF-8. */
    int TEXT_BYTES = 3000;

    UUID session();

    /** A coordinator opens a session. */
    record OpenSession(UUID session, String release) implements Message {}

    /** A node is there for it. @param memory bytes that it may take for frames */
    record SessionOpened(UUID session, String release, int threads, long memory) implements Message {}

    /** Wants a frame to show a take, which a bill tells. @param billBytes the length of the bill */
    record UpdateFrame(UUID session, long call, int frame, ContentHash manifest, int manifestBytes) implements Message {}

    /**
     * The frame shows it.
     *
     * @param memory bytes that frames of the session take in memory
     * @param disk   and on disk
     */
    record FrameUpdated(UUID session, long call, boolean traced, String plan, long rays, long nanoseconds, int width, int height,
            long memory,
            long disk) implements Message {}

    /** The frame does not. */
    record UpdateFailed(UUID session, long call, FailureReason reason, String message) implements Message {}

    /** Why a frame was not brought to a take. */
    enum FailureReason {
        /** It was asked to stop. */
        CANCELED,
        /** The take has no such frame, or is none. */
        INVALID,
        /** This node has no room for it, or for what it needs; another may. */
        REJECTED,
        /** An error of the program. */
        ERROR
    }

    /** Wants no more that a frame is brought. */
    record CancelUpdate(UUID session, long call) implements Message {}

    /** Asks for content. */
    record RequestContent(UUID session, ContentHash hash, long offset) implements Message {}

    /** Some of the content, at most {@link #PART_BYTES}; empty at its end, and where there is none such. */
    record ContentPart(UUID session, ContentHash hash, long offset, byte[] bytes) implements Message {}

    /**
     * Asks for tiles of the film that a call made, made smaller so as to have room.
     *
     * @param maxWidth pixels; likewise {@code maxHeight}
     */
    record RequestTiles(UUID session, long call, int frame, int maxWidth, int maxHeight, int firstTile, int tileCount) implements Message {}

    /** Tiles of that film: of each all red, all green, all blue, floats with their highest byte first. */
    record FilmTileData(UUID session, long call, int frame, int maxWidth, int maxHeight, int firstTile, byte[] bytes) implements Message {}

    /** The film of that call is there no more. */
    record FilmUnavailable(UUID session, long call, int frame) implements Message {}

    /** Tells which frame is looked at. */
    record FocusFrame(UUID session, int frame) implements Message {}

    /** Wants a frame to be dropped. */
    record DropFrame(UUID session, int frame) implements Message {}

    /** Asks whether a node still has a session; it says the same, or that the session has ended. */
    record Heartbeat(UUID session) implements Message {}

    /** Ends a session; of a node, that it has none such. */
    record CloseSession(UUID session) implements Message {}
}
