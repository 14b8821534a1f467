package lightning.scene;

/** What an attribute's values do between two keys of a shot. */
public enum KeyframeSupport {
    /** Numbers, which may go from one key to the next. */
    INTERPOLATED,
    /** Words and whole numbers, which stay what they are until the next key. */
    STEPPED,
    /** Names, links and files, which have no keys. */
    NONE
}
