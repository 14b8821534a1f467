package lightning.shot;

/**
 * Listener for frames of a shot. Called on the shot's threads, in order for each frame and concurrently for different frames; a UI must
 * forward to its own thread. A slow call delays other frames.
 */
public interface ShotListener {
    /** Listener that does nothing. */
    ShotListener NONE = new ShotListener() {};

    /**
     * Reports a frame's new film.
     *
     * @param state {@link FrameState#CURRENT}, or {@link FrameState#STALE} if a newer edit came meanwhile
     */
    default void frameUpdated(FrameUpdate update, FrameState state) {}

    /** Reports that the newest edit cannot be rendered at a frame; the next edit tries it again. */
    default void frameFailed(int frame, Throwable problem) {}

    /** Reports a new host. */
    default void hostAdded() {}

    /** Reports the loss of a host; its frames are missing, and other hosts, if any, trace them. */
    default void hostLost(HostLostException problem) {}

    /** Reports that all frames are current or failed. */
    default void shotIdle() {}
}
