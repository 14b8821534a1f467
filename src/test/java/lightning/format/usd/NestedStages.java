package lightning.format.usd;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Stages of nested references: each level has ten prims that refer to the next one. */
public final class NestedStages {
    private NestedStages() {}

    /** Writes a stage whose root composes to 10^levels prims. */
    public static Path write(Path file, int levels) throws IOException {
        var text = new StringBuilder("#usda 1.0\n(\n defaultPrim = \"l0\"\n)\n");
        for (int level = 0; level < levels; level++) {
            text.append("def Xform \"l").append(level).append("\" {\n");
            for (int i = 0; i < 10; i++) {
                text.append(" def Xform \"c").append(i).append("\" (references = </l").append(level + 1).append(">) {}\n");
            }
            text.append("}\n");
        }
        return Files.writeString(file, text.append("def Xform \"l").append(levels).append("\" { def Sphere \"s\" {}\n}\n"));
    }
}
