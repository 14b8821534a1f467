package lightning.base.text;

/**
 * A value, scene or file that cannot be used; the message says why, for the user. Other {@link IllegalArgumentException}s are bugs: nothing catches
 * them to show their message.
 */
public final class RefusalException extends IllegalArgumentException implements UserFacingException {
    private static final long serialVersionUID = 1;

    /** @param message a sentence, possibly without its full stop */
    public RefusalException(String message) {
        super(message);
    }

    /** @param message as above */
    public RefusalException(String message, Throwable cause) {
        super(message, cause);
    }

    @Override
    public String getMessage() {
        return String.valueOf(super.getMessage());
    }
}
