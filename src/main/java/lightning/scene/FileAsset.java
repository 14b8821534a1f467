package lightning.scene;

/** What a scene names by a file, with what that holds. */
public sealed interface FileAsset permits Gobo, IesProfile, Environment {
    /** The name as written in the scene file. */
    String file();

    /** What it holds: two that hold the same are alike, whatever their files are called. */
    Object content();
}
