package lightning.shot.cluster.wire;

import java.util.UUID;
import lightning.base.file.ContentHash;

/**
 * Message between members of a cluster. A coordinator requests, a node answers. Any message may arrive twice or be repeated; a lost message
 * only costs time.
 *
 * <p>A session is one node's frames for one coordinator. A call is one request within it, and identifies the resulting film.
 */
public sealed interface Message {
    /** Maximum bytes of a message. */
    int MAX_BYTES = 1 << 21;
    /** Maximum bytes of content in one message. */
    int PART_BYTES = 1 << 20;
    /** Maximum bytes of a text, in UTF-8. */
    int TEXT_BYTES = 3000;

    UUID session();

    /** Opens a session; sent by a coordinator. */
    record OpenSession(UUID session, String release) implements Message {}

    /** Accepts a session; sent by a node. @param memory bytes available for frames */
    record SessionOpened(UUID session, String release, int threads, long memory) implements Message {}

    /** Requests a frame in the revision of a manifest. @param manifestBytes length of the manifest */
    record UpdateFrame(UUID session, long call, int frame, ContentHash manifest, int manifestBytes) implements Message {}

    /**
     * Reports an updated frame.
     *
     * @param memory bytes of the session's frames in memory
     * @param disk   bytes of the session's frames on disk
     */
    record FrameUpdated(UUID session, long call, boolean traced, String plan, long rays, long nanoseconds, int width, int height,
            long memory,
            long disk) implements Message {}

    /** Reports a failed update. */
    record UpdateFailed(UUID session, long call, FailureReason reason, String message) implements Message {}

    /** Reason of a failed update. */
    enum FailureReason {
        /** The update was canceled. */
        CANCELED,
        /** The revision is invalid or has no such frame. */
        INVALID,
        /** This node lacks memory or disk space; another may have it. */
        REJECTED,
        /** Internal error. */
        ERROR
    }

    /** Cancels a request. */
    record CancelUpdate(UUID session, long call) implements Message {}

    /** Requests content. */
    record RequestContent(UUID session, ContentHash hash, long offset) implements Message {}

    /** Part of the content, at most {@link #PART_BYTES}; empty at its end or for an unknown hash. */
    record ContentPart(UUID session, ContentHash hash, long offset, byte[] bytes) implements Message {}

    /**
     * Requests tiles of a call's film, downscaled to fit.
     *
     * @param maxWidth  pixels
     * @param maxHeight pixels
     */
    record RequestTiles(UUID session, long call, int frame, int maxWidth, int maxHeight, int firstTile, int tileCount) implements Message {}

    /** Tiles of the film: for each all red, all green, all blue, as big-endian floats. */
    record FilmTileData(UUID session, long call, int frame, int maxWidth, int maxHeight, int firstTile, byte[] bytes) implements Message {}

    /** Reports that the call's film is gone. */
    record FilmUnavailable(UUID session, long call, int frame) implements Message {}

    /** Sets the focused frame. */
    record FocusFrame(UUID session, int frame) implements Message {}

    /** Drops a frame. */
    record DropFrame(UUID session, int frame) implements Message {}

    /** Checks that a node still has a session; the node echoes it, or answers that the session has ended. */
    record Heartbeat(UUID session) implements Message {}

    /** Ends a session; from a node, reports that the session does not exist. */
    record CloseSession(UUID session) implements Message {}
}
