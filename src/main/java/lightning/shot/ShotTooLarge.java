package lightning.shot;

import lightning.base.text.Told;

/** The frames of a shot fit neither into memory nor on disk. The message is a sentence without its full stop that says what would fit. */
public final class ShotTooLarge extends RuntimeException implements Told {
    private static final long serialVersionUID = 1;

    ShotTooLarge(String message) {
        super(message);
    }
}
