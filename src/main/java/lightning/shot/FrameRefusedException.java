package lightning.shot;

import lightning.base.text.Told;

/** A keeper cannot hold a frame that another may: for want of room, or of what it needs for it. The message is a sentence without its full stop. */
public final class FrameRefusedException extends RuntimeException implements Told {
    private static final long serialVersionUID = 1;

    public FrameRefusedException(String message) {
        super(message);
    }
}
