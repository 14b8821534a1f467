package lightning.scene.asset;

import lightning.base.file.ContentDigest;

/** File referenced by a scene, with its decoded content. */
public sealed interface FileAsset permits Gobo, IesProfile, LightTexture, Environment {
    /** Returns the name as written in the scene file. */
    String file();

    /** Returns the content; assets with equal content are equivalent, whatever their file names. */
    ContentDigest.Content content();
}
