package lightning.format.mesh.obj;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import lightning.base.math.Rgb;
import lightning.base.text.Quote;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.Notes;
import lightning.format.mesh.TextSource;

/** Reads MTL files: colours, shininess and the picture of the diffuse colour. What else they hold is told. */
public final class MtlReader {
    private final TextSource text;
    private final Notes notes;
    private final Map<String, MtlMaterial> materials = new LinkedHashMap<>();
    private Draft now;

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
            materials.putIfAbsent(now.name, now.made());
        }
    }

    private void statement() throws IOException, MeshException {
        String keyword = text.length() <= 32 ? text.text() : Quote.of(text.text());
        if (keyword.equals("newmtl")) {
            keep();
            if (materials.size() == MeshLimits.PARTS) {
                throw text.problem("a file must have at most " + MeshLimits.PARTS + " materials");
            }
            now = new Draft(text.rest());
            return;
        }
        if (now == null) {
            throw text.problem("newmtl must stand before " + keyword);
        }
        switch (keyword) {
            case "Kd" -> now.diffuse = color(now.diffuse);
            case "Ks" -> now.specular = color(now.specular);
            case "Ke" -> now.emission = color(now.emission);
            case "Ns" -> now.shininess = OptionalDouble.of(number());
            case "illum" -> now.illumination = illumination();
            case "d" -> now.opacity = opacity();
            case "Tr" -> now.transparency = number();
            case "Tf" -> now.filter = color(now.filter);
            case "Ni" -> now.ior = number();
            case "map_Kd" -> now.texture = picture();
            // Most writers put 1 there whatever the surface is, which would make it shine.
            case "Ka" -> notes.add("ambient colours (Ka) of materials");
            case "map_d" -> now.cutout = picture();
            default -> notes.add(keyword + " of materials");
        }
    }

    /** The highlight model where the number names none. */
    private Illumination illumination() throws IOException, MeshException {
        Optional<Illumination> model = Illumination.of(number());
        if (model.isEmpty() || model.get() == Illumination.SHADOW_CATCHER) {
            notes.add("illumination models (illum) of materials that are not 0 to 9");
        }
        return model.orElse(Illumination.HIGHLIGHT);
    }

    /** Of {@code -halo}, by which the middle is clearer than the rim, the number alone. */
    private double opacity() throws IOException, MeshException {
        if (text.word() && text.is("-halo")) {
            notes.add("materials that are clearer in their middle");
            return number();
        }
        return value();
    }

    /** A material of which not all lines are read. */
    private static final class Draft {
        final String name;
        Rgb diffuse = Rgb.grey(0.8);
        Rgb specular = Rgb.BLACK;
        Rgb emission = Rgb.BLACK;
        OptionalDouble shininess = OptionalDouble.empty();
        Illumination illumination = Illumination.HIGHLIGHT;
        double opacity = Double.NaN;
        double transparency = Double.NaN;
        Rgb filter;
        double ior = 1.5;
        Optional<String> texture = Optional.empty();
        Optional<String> cutout = Optional.empty();

        Draft(String name) {
            this.name = name;
        }

        MtlMaterial made() {
            return new MtlMaterial(name, illumination, diffuse, specular, emission, shininess, there(), filter == null ? Rgb.WHITE : filter,
                    ior, texture, cutout);
        }

        /**
         * By d, or by Tr where there is no d. Some writers put 1 into Tr for what is there: alone, and by a model that lets nothing through, it
         * is taken so. By models that refract a filter alone says how much passes.
         */
        private double there() {
            if (!Double.isNaN(opacity) && opacity != 1) {
                return opacity;
            }
            if (illumination.refracts() && filter != null) {
                return 0;
            }
            boolean alone = Double.isNaN(opacity) && !Double.isNaN(transparency);
            return alone && (transparency != 1 || illumination.transmits()) ? 1 - transparency : 1;
        }
    }

    private double number() throws IOException, MeshException {
        text.word();
        return value();
    }

    /** The number that the word is which was found last. */
    private double value() throws MeshException {
        if (text.length() == 0) {
            throw text.problem("expected a number, found the end of the line");
        }
        return text.number("it");
    }

    /** One number stands for all three. */
    private Rgb color(Rgb otherwise) throws IOException, MeshException {
        if (text.word() && (text.is("spectral") || text.is("xyz"))) {
            notes.add("colours of materials that are no red, green and blue");
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
