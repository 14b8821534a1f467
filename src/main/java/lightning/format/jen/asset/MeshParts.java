package lightning.format.jen.asset;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.file.UnusableFileException;
import lightning.base.text.Quote;
import lightning.format.mesh.NamedMesh;
import lightning.scene.node.Mesh;
import org.jspecify.annotations.Nullable;

/** Meshes of one file, with constant-time lookup by name. */
final class MeshParts {
    private final List<NamedMesh> parts;
    private final Map<String, Mesh> byName = new HashMap<>();
    private @Nullable Mesh mergedMesh;

    /**
     * Creates the lookup.
     *
     * @param parts at least one; the first of several with the same name is used
     */
    MeshParts(List<NamedMesh> parts) {
        this.parts = parts;
        for (NamedMesh part : parts) {
            byName.putIfAbsent(part.name(), MeshPool.shared(part.mesh()));
        }
    }

    /** Returns all parts merged into one mesh, cached. */
    Mesh merged() throws UnusableFileException {
        if (mergedMesh == null) {
            mergedMesh = MeshPool.shared(
                    parts.size() == 1 ? parts.getFirst().mesh() : MeshMerger.merge(parts.stream().map(NamedMesh::mesh).toList()));
        }
        return mergedMesh;
    }

    /**
     * Returns the part of a name.
     *
     * @param file name of the file in messages
     * @throws UnusableFileException if there is no such part
     */
    Mesh part(String part, String file) throws UnusableFileException {
        Mesh mesh = byName.get(part);
        if (mesh == null) {
            throw new UnusableFileException("mesh file " + Quote.of(file) + " has no part " + Quote.of(part)
                    + NameSuggestion.hint(part, parts.stream().map(NamedMesh::name).toList()));
        }
        return mesh;
    }
}
