package lightning.format.gltf;

import java.nio.file.Path;
import lightning.format.mesh.MeshException;

/** A file of glTF 1.0, which has other structures. */
public final class OldGltfException extends MeshException {
    private static final long serialVersionUID = 1;

    OldGltfException(Path file) {
        super(file, "", "is glTF 1.0; export it as glTF 2.0");
    }
}
