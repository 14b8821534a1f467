package lightning.scene;

/** What an attribute's values do between two keys of a shot. */
public enum Keying {
    /** Numbers, which may go from one key to the next. */
    GLIDES,
    /** Words and whole numbers, which stay what they are until the next key. */
    HOLDS,
    /** Names, links and files, which have no keys. */
    NONE
}
