package lightning.relight;

/** A picture does not fit into the memory that there is. The message is a sentence without its full stop that says what would. */
public final class PictureTooLarge extends RuntimeException {
    private static final long serialVersionUID = 1;

    PictureTooLarge(String message) {
        super(message);
    }
}
