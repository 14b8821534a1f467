package lightning.format;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import lightning.base.work.Progress;
import lightning.format.gltf.GltfFile;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.ply.PlyReader;

/** What a file of meshes is: its content says it, or its name where the content has no mark. */
public enum MeshFormat {
    PLY,
    OBJ,
    NFF,
    GLTF;

    private static final byte[] UTF_16 = {(byte) 0xFE, (byte) 0xFF};
    private static final byte[] UTF_16_SWAPPED = {(byte) 0xFF, (byte) 0xFE};

    /**
     * The format of a file.
     *
     * @throws MeshException if it is none of them
     * @throws IOException   if it cannot be read, or is a folder, a pipe or a device
     */
    public static MeshFormat of(Path file) throws IOException, MeshException {
        try (ByteSource source = ByteSource.open(file, Progress.NONE)) {
            return of(file, source);
        }
    }

    /** The same of a file that is open, of which nothing was read yet, and nothing is. */
    static MeshFormat of(Path file, ByteSource source) throws IOException, MeshException {
        if (PlyReader.isPly(source)) {
            return PLY;
        }
        if (GltfFile.isGltf(source)) {
            return GLTF;
        }
        if (source.startsWith(UTF_16) || source.startsWith(UTF_16_SWAPPED)) {
            throw source.problem("", "is text in UTF-16; save it as UTF-8");
        }
        String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
        if (name.endsWith(".obj")) {
            return OBJ;
        }
        if (name.endsWith(".nff")) {
            return NFF;
        }
        throw source.problem("", "must be a PLY, OBJ, NFF or glTF file, found another kind");
    }
}
