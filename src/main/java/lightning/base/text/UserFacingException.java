package lightning.base.text;

/** Exception about the user's input or environment, not a bug; its message is shown as it is. */
public interface UserFacingException {
    /** Returns a sentence, possibly without its full stop; several problems of one file have a line each. */
    String getMessage();
}
