package lightning.format.mesh.obj;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import lightning.base.math.Rgb;
import lightning.base.text.Quote;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.TextTokenizer;

/** Reads MTL files: colors, shininess and the picture of the diffuse color. What else they hold is told. */
public final class MtlReader {
    private final TextTokenizer text;
    private final ConversionNotes notes;
    private final Map<String, MtlMaterial> materials = new LinkedHashMap<>();
    private MaterialBuilder current;

    private MtlReader(ByteSource source, ConversionNotes notes) {
        this.notes = notes;
        text = new TextTokenizer(source);
    }

    /**
     * The materials of a file by their names; of two with one name the first.
     *
     * @throws MeshException if it is damaged
     * @throws IOException   if it cannot be read
     */
    public static Map<String, MtlMaterial> read(ByteSource source, ConversionNotes notes) throws IOException, MeshException {
        return new MtlReader(source, notes).read();
    }

    private Map<String, MtlMaterial> read() throws IOException, MeshException {
        do {
            if (text.readToken() && text.byteAt(0) != '#') {
                readStatement();
            }
        } while (text.nextLine());
        finishMaterial();
        return materials;
    }

    private void finishMaterial() {
        if (current != null) {
            materials.putIfAbsent(current.name, current.build());
        }
    }

    private void readStatement() throws IOException, MeshException {
        String keyword = text.length() <= 32 ? text.text() : Quote.of(text.text());
        if (keyword.equals("newmtl")) {
            finishMaterial();
            if (materials.size() == MeshLimits.PARTS) {
                throw text.problem("a file must have at most " + MeshLimits.PARTS + " materials");
            }
            current = new MaterialBuilder(text.restOfLine());
            return;
        }
        if (current == null) {
            throw text.problem("newmtl must stand before " + keyword);
        }
        switch (keyword) {
            case "Kd" -> current.diffuse = readColor(current.diffuse);
            case "Ks" -> current.specular = readColor(current.specular);
            case "Ke" -> current.emission = readColor(current.emission);
            case "Ns" -> current.shininess = OptionalDouble.of(readNumber());
            case "illum" -> current.illumination = readIllumination();
            case "d" -> current.opacity = readOpacity();
            case "Tr" -> current.transparency = readNumber();
            case "Tf" -> current.filter = readColor(current.filter);
            case "Ni" -> current.ior = readNumber();
            case "map_Kd" -> current.texture = readTexturePath();
            // Most writers put 1 there whatever the surface is, which would make it shine.
            case "Ka" -> notes.add("ambient colors (Ka) of materials");
            case "map_d" -> current.cutout = readTexturePath();
            default -> notes.add(keyword + " of materials");
        }
    }

    /** The highlight model where the number names none. */
    private IlluminationModel readIllumination() throws IOException, MeshException {
        Optional<IlluminationModel> model = IlluminationModel.of(readNumber());
        if (model.isEmpty() || model.get() == IlluminationModel.SHADOW_CATCHER) {
            notes.add("illumination models (illum) of materials that are not 0 to 9");
        }
        return model.orElse(IlluminationModel.HIGHLIGHT);
    }

    /** Of {@code -halo}, by which the middle is clearer than the rim, the number alone. */
    private double readOpacity() throws IOException, MeshException {
        if (text.readToken() && text.isToken("-halo")) {
            notes.add("materials that are clearer in their middle");
            return readNumber();
        }
        return parseNumber();
    }

    /** A material of which not all lines are read. */
    private static final class MaterialBuilder {
        final String name;
        Rgb diffuse = Rgb.gray(0.8);
        Rgb specular = Rgb.BLACK;
        Rgb emission = Rgb.BLACK;
        OptionalDouble shininess = OptionalDouble.empty();
        IlluminationModel illumination = IlluminationModel.HIGHLIGHT;
        double opacity = Double.NaN;
        double transparency = Double.NaN;
        Rgb filter;
        double ior = 1.5;
        Optional<String> texture = Optional.empty();
        Optional<String> cutout = Optional.empty();

        MaterialBuilder(String name) {
            this.name = name;
        }

        MtlMaterial build() {
            return new MtlMaterial(name, illumination, diffuse, specular, emission, shininess, effectiveOpacity(),
                    filter == null ? Rgb.WHITE : filter,
                    ior, texture, cutout);
        }

        /**
         * By d, or by Tr where there is no d. Some writers put 1 into Tr for what is there: alone, and by a model that lets nothing through, it
         * is taken so. By models that refract a filter alone says how much passes.
         */
        private double effectiveOpacity() {
            if (!Double.isNaN(opacity) && opacity != 1) {
                return opacity;
            }
            if (illumination.isRefractive() && filter != null) {
                return 0;
            }
            boolean hasOnlyTransparency = Double.isNaN(opacity) && !Double.isNaN(transparency);
            return hasOnlyTransparency && (transparency != 1 || illumination.isTransmissive()) ? 1 - transparency : 1;
        }
    }

    private double readNumber() throws IOException, MeshException {
        text.readToken();
        return parseNumber();
    }

    /** The number that the word is which was found last. */
    private double parseNumber() throws MeshException {
        if (text.length() == 0) {
            throw text.problem("expected a number, found the end of the line");
        }
        return text.number("it");
    }

    /** One number stands for all three. */
    private Rgb readColor(Rgb fallback) throws IOException, MeshException {
        if (text.readToken() && (text.isToken("spectral") || text.isToken("xyz"))) {
            notes.add("colors of materials that are no red, green and blue");
            return fallback;
        }
        double red = text.number("red");
        if (!text.readToken()) {
            return Rgb.gray(red);
        }
        return new Rgb(red, text.number("green"), readNumber());
    }

    /** The name behind the options, each of which is a word with a hyphen and what belongs to it. */
    private Optional<String> readTexturePath() throws IOException, MeshException {
        String rest = text.restOfLine();
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
                String[] split = rest.split("\\s+", 2);
                // Of -o, -s and -t the last numbers may be missing.
                if (i > 0 && !split[0].matches("[-+0-9.eE]+")) {
                    break;
                }
                rest = split.length < 2 ? "" : split[1];
            }
        }
        return rest.isEmpty() ? Optional.empty() : Optional.of(rest);
    }
}
