package lightning.base.text;

/** A problem of what the program was given or can do here, not of itself: its message is for whoever uses it, as it stands. */
public interface UserFacingException {
    /** A sentence, which may lack its full stop; several problems of one file have a line each. */
    String getMessage();
}
