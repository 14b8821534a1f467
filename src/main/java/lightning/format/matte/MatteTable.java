package lightning.format.matte;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.format.exr.ExrAttribute;
import lightning.scene.Stage;
import tools.jackson.databind.json.JsonMapper;

/** Ids of a stage's shapes in one kind of mattes, and the header that describes them. */
public final class MatteTable {
    /** Digits of the hash of the layer's name in the names of attributes. */
    private static final int KEY_LENGTH = 7;

    private final MatteKind kind;
    private final int[] bits;
    private final Map<String, String> manifest = new LinkedHashMap<>();

    public MatteTable(MatteKind kind, Stage stage) {
        this.kind = kind;
        List<String> names = kind.names(stage);
        bits = new int[names.size()];
        for (int s = 0; s < bits.length; s++) {
            bits[s] = MatteId.bits(names.get(s));
            manifest.put(names.get(s), MatteId.hex(bits[s]));
        }
    }

    /** Returns the bits of the id of a shape: its position in {@link Stage#shapes}. */
    public int bits(int shape) {
        return bits[shape];
    }

    /** Returns the attributes of a file's header that describe these mattes, with the id of each name. */
    public Map<String, ExrAttribute> attributes() {
        String prefix = "cryptomatte/" + MatteId.hex(MatteId.hash(kind.layer())).substring(0, KEY_LENGTH) + "/";
        Map<String, ExrAttribute> attributes = new LinkedHashMap<>();
        attributes.put(prefix + "name", new ExrAttribute.Text(kind.layer()));
        attributes.put(prefix + "hash", new ExrAttribute.Text("MurmurHash3_32"));
        attributes.put(prefix + "conversion", new ExrAttribute.Text("uint32_to_float32"));
        attributes.put(prefix + "manifest", new ExrAttribute.Text(new JsonMapper().writeValueAsString(manifest)));
        return attributes;
    }
}
