package lightning.mesh.obj;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import lightning.math.Rgb;
import lightning.mesh.ByteSource;
import lightning.mesh.MeshException;
import lightning.mesh.MeshLimits;
import lightning.mesh.Notes;
import lightning.mesh.TextSource;
import lightning.text.Quote;

/** Reads MTL files: colours, shininess and the picture of the diffuse colour. What else they hold is told. */
public final class MtlReader {
    private final TextSource text;
    private final Notes notes;
    private final Map<String, MtlMaterial> materials = new LinkedHashMap<>();
    private MtlMaterial now;

    private MtlReader(ByteSource source, Notes notes) {
        this.notes = notes;
        text = new TextSource(source);
    }

    /**
     * The materials of a file by their names; of two with one name the first.
     *
     * @throws MeshException if it is damaged
     * @throws IOException   if it cannot be read
     */
    public static Map<String, MtlMaterial> read(ByteSource source, Notes notes) throws IOException, MeshException {
        return new MtlReader(source, notes).read();
    }

    private Map<String, MtlMaterial> read() throws IOException, MeshException {
        do {
            if (text.word() && text.at(0) != '#') {
                statement();
            }
        } while (text.nextLine());
        keep();
        return materials;
    }

    private void keep() {
        if (now != null) {
            materials.putIfAbsent(now.name(), now);
        }
    }

    private void statement() throws IOException, MeshException {
        String keyword = text.length() <= 32 ? text.text() : Quote.of(text.text());
        if (keyword.equals("newmtl")) {
            keep();
            if (materials.size() == MeshLimits.PARTS) {
                throw text.problem("a file must have at most " + MeshLimits.PARTS + " materials");
            }
            now = MtlMaterial.of(text.rest());
            return;
        }
        if (now == null) {
            throw text.problem("newmtl must stand before " + keyword);
        }
        MtlMaterial m = now;
        now = switch (keyword) {
            case "Kd" -> new MtlMaterial(m.name(), color(m.diffuse()), m.specular(), m.emission(), m.shininess(), m.mirrors(), m.texture());
            case "Ks" -> new MtlMaterial(m.name(), m.diffuse(), color(m.specular()), m.emission(), m.shininess(), m.mirrors(), m.texture());
            case "Ke" -> new MtlMaterial(m.name(), m.diffuse(), m.specular(), color(m.emission()), m.shininess(), m.mirrors(), m.texture());
            case "Ns" -> new MtlMaterial(m.name(), m.diffuse(), m.specular(), m.emission(), number(), m.mirrors(), m.texture());
            case "illum" ->
                    new MtlMaterial(m.name(), m.diffuse(), m.specular(), m.emission(), m.shininess(), mirrors(number()), m.texture());
            case "map_Kd" -> new MtlMaterial(m.name(), m.diffuse(), m.specular(), m.emission(), m.shininess(), m.mirrors(), picture());
            // Most writers put 1 there whatever the surface is, which would make it shine.
            case "Ka" -> left("ambient colors (Ka) of materials");
            // Opaque, as all is here.
            case "d" -> number() == 1 ? m : left("transparent materials");
            case "Tr" -> number() == 0 ? m : left("transparent materials");
            case "Ni" -> m;
            default -> left(keyword + " of materials");
        };
    }

    private static boolean mirrors(double illumination) {
        return illumination >= 3 && illumination <= 9 && illumination != 4 && illumination != 9;
    }

    private MtlMaterial left(String kind) {
        notes.add(kind);
        return now;
    }

    private double number() throws IOException, MeshException {
        if (!text.word()) {
            throw text.problem("expected a number, found the end of the line");
        }
        return text.number("it");
    }

    /** One number stands for all three. */
    private Rgb color(Rgb otherwise) throws IOException, MeshException {
        if (text.word() && (text.is("spectral") || text.is("xyz"))) {
            notes.add("colors of materials that are no red, green and blue");
            return otherwise;
        }
        double red = text.number("red");
        if (!text.word()) {
            return Rgb.grey(red);
        }
        return new Rgb(red, text.number("green"), number());
    }

    /** The name behind the options, each of which is a word with a hyphen and what belongs to it. */
    private Optional<String> picture() throws IOException, MeshException {
        String rest = text.rest();
        while (rest.startsWith("-")) {
            String[] words = rest.split("\\s+", 3);
            notes.add("options " + words[0] + " of pictures");
            int numbers = switch (words[0]) {
                case "-mm" -> 2;
                case "-o", "-s", "-t" -> 3;
                default -> 1;
            };
            rest = words.length < 2 ? "" : rest.substring(rest.indexOf(words[1], words[0].length()));
            for (int i = 0; i < numbers && !rest.isEmpty(); i++) {
                String[] next = rest.split("\\s+", 2);
                // Of -o, -s and -t the last numbers may be missing.
                if (i > 0 && !next[0].matches("[-+0-9.eE]+")) {
                    break;
                }
                rest = next.length < 2 ? "" : next[1];
            }
        }
        return rest.isEmpty() ? Optional.empty() : Optional.of(rest);
    }
}
