package lightning.shot;

/**
 * Hears of frames. Called on the shot's own threads, of one frame in the order of its films, and of several frames at once: whoever
 * shows them hands on to a thread of its own. A call that takes long keeps other frames waiting.
 */
public interface ShotListener {
    /** Hears nothing. */
    ShotListener NONE = new ShotListener() {};

    /**
     * A frame has a new film.
     *
     * @param state {@link FrameState#CURRENT}, or {@link FrameState#STALE} where a newer edit came meanwhile
     */
    default void frameUpdated(FrameUpdate update, FrameState state) {}

    /** The newest edit cannot be made in a frame; it is tried again at the next edit. */
    default void frameFailed(int frame, Throwable problem) {}

    /** One more holds frames from here on. */
    default void hostAdded() {}

    /** What held frames is gone; these are missing, and others trace them, if there are any. */
    default void hostLost(HostLostException problem) {}

    /** All frames are current or failed. */
    default void shotIdle() {}
}
