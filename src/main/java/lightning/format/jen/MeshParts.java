package lightning.format.jen;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.text.Quote;
import lightning.format.mesh.NamedMesh;
import lightning.scene.Mesh;

/** The meshes of one file, found by name in the same time however many there are. */
final class MeshParts {
    private final List<NamedMesh> parts;
    private final Map<String, Mesh> byName = new HashMap<>();
    private Mesh mergedMesh;

    /** @param parts at least one; of two with the same name the first is found */
    MeshParts(List<NamedMesh> parts) {
        this.parts = parts;
        for (NamedMesh part : parts) {
            byName.putIfAbsent(part.name(), part.mesh());
        }
    }

    /** All parts as one mesh, joined once. */
    Mesh merged() throws UnusableFileException {
        if (mergedMesh == null) {
            mergedMesh = parts.size() == 1 ? parts.getFirst().mesh() : MeshMerger.merge(parts.stream().map(NamedMesh::mesh).toList());
        }
        return mergedMesh;
    }

    /**
     * The part of a name.
     *
     * @param file what messages call the file
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
