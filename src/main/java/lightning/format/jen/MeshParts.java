package lightning.format.jen;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.text.Quote;
import lightning.format.mesh.NamedMesh;
import lightning.scene.Mesh;

/** The meshes of one file, found by name in the same time however many there are. */
final class MeshParts {
    private final List<NamedMesh> all;
    private final Map<String, Mesh> byName = new HashMap<>();
    private Mesh whole;

    /** @param all at least one; of two with the same name the first is found */
    MeshParts(List<NamedMesh> all) {
        this.all = all;
        for (NamedMesh part : all) {
            byName.putIfAbsent(part.name(), part.mesh());
        }
    }

    /** All parts as one mesh, joined once. */
    Mesh whole() throws UnusableFileException {
        if (whole == null) {
            whole = all.size() == 1 ? all.getFirst().mesh() : MeshUnion.of(all.stream().map(NamedMesh::mesh).toList());
        }
        return whole;
    }

    /**
     * The part of a name.
     *
     * @param file what messages call the file
     * @throws UnusableFileException if there is no such part
     */
    Mesh named(String part, String file) throws UnusableFileException {
        Mesh mesh = byName.get(part);
        if (mesh == null) {
            throw new UnusableFileException("mesh file " + Quote.of(file) + " has no part " + Quote.of(part)
                    + Nearest.hint(part, all.stream().map(NamedMesh::name).toList()));
        }
        return mesh;
    }
}
