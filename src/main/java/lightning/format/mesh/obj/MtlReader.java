package lightning.format.mesh.obj;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import lightning.base.math.Rgb;
import lightning.base.text.DecimalNumber;
import lightning.base.text.PrintableText;
import lightning.base.text.Quote;
import lightning.format.mesh.BadLineException;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.TextTokenizer;
import org.jspecify.annotations.Nullable;

/** Reader for MTL files: colors, shininess and images. Notes all other content. */
public final class MtlReader {
    private static final Pattern NUMBER = Pattern.compile("[-+0-9.eE]+");

    private final TextTokenizer text;
    private final ConversionNotes notes;
    private final String name;
    private final Map<String, MtlMaterial> materials = new LinkedHashMap<>();
    private @Nullable MaterialBuilder current;

    private MtlReader(ByteSource source, ConversionNotes notes) {
        this.notes = notes;
        name = PrintableText.escape(String.valueOf(source.file().getFileName()));
        text = new TextTokenizer(source);
    }

    /**
     * Reads the materials of a file by name; the first of several with one name is used.
     *
     * @throws MeshException if the file is invalid
     * @throws IOException if it cannot be read
     */
    public static Map<String, MtlMaterial> read(ByteSource source, ConversionNotes notes) throws IOException, MeshException {
        return new MtlReader(source, notes).read();
    }

    private Map<String, MtlMaterial> read() throws IOException, MeshException {
        text.skipByteOrderMark();
        do {
            try {
                if (text.readToken() && text.byteAt(0) != '#') {
                    readStatement();
                }
            } catch (BadLineException e) {
                notes.add(name + ", " + e.note());
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
            throw text.badLine("newmtl must stand before " + keyword);
        }
        switch (keyword) {
            case "Kd" -> current.diffuse = readColor().orElse(current.diffuse);
            case "Ks" -> current.specular = readColor().orElse(current.specular);
            case "Ke" -> current.emission = readColor().orElse(current.emission);
            case "Ns" -> current.shininess = OptionalDouble.of(readNumber());
            case "illum" -> current.illumination = readIllumination();
            case "d" -> current.opacity = readOpacity();
            case "Tr" -> current.transparency = readNumber();
            case "Tf" -> current.filter = readColor().orElse(current.filter);
            case "Ni" -> current.ior = readNumber();
            case "map_Kd" -> current.texture = readImage(false);
            case "map_Ke" -> current.emissionMap = readImage(false);
            // Most writers use 1 for any surface, which would make it emit light.
            case "Ka" -> notes.add("ambient colors (Ka) of materials");
            case "map_d" -> current.cutout = readImage(false);
            case "map_Bump", "map_bump", "bump" -> current.setBump(readImage(false));
            case "norm" -> current.setBump(readImage(true));
            case "Pr" -> current.roughness = OptionalDouble.of(readNumber());
            case "Pm" -> current.metalness = OptionalDouble.of(readNumber());
            case "map_Pr" -> current.roughnessMap = readImage(false);
            case "map_Pm" -> current.metalnessMap = readImage(false);
            case "map_Pc" -> current.coatMap = readImage(false);
            case "map_Pcr" -> current.coatRoughnessMap = readImage(false);
            case "Pc" -> current.coat = readNumber();
            case "Pcr" -> current.coatRoughness = readNumber();
            case "Ps" -> current.sheen = readNumber();
            case "aniso" -> current.anisotropy = readNumber();
            case "anisor" -> current.anisotropyRotation = readNumber();
            default -> notes.add(keyword + " of materials");
        }
    }

    /** Reads an illumination model; the highlight model if the number is unknown. */
    private IlluminationModel readIllumination() throws IOException, MeshException {
        Optional<IlluminationModel> model = IlluminationModel.of(readNumber());
        if (model.isEmpty() || model.get() == IlluminationModel.SHADOW_CATCHER) {
            notes.add("illumination models (illum) of materials that are not 0 to 9");
        }
        return model.orElse(IlluminationModel.HIGHLIGHT);
    }

    /** Reads an opacity; ignores {@code -halo}, which varies it from center to rim. */
    private double readOpacity() throws IOException, MeshException {
        if (text.readToken() && text.isToken("-halo")) {
            notes.add("view-dependent opacity (d -halo) of materials");
            return readNumber();
        }
        return parseNumber();
    }

    /** Builder of a material from its lines. */
    private static final class MaterialBuilder {
        final String name;
        Rgb diffuse = Rgb.gray(0.8);
        Rgb specular = Rgb.BLACK;
        Rgb emission = Rgb.BLACK;
        OptionalDouble shininess = OptionalDouble.empty();
        IlluminationModel illumination = IlluminationModel.HIGHLIGHT;
        double opacity = Double.NaN;
        double transparency = Double.NaN;
        @Nullable
        Rgb filter;
        double ior = 1.5;
        OptionalDouble roughness = OptionalDouble.empty();
        OptionalDouble metalness = OptionalDouble.empty();
        double coat;
        double coatRoughness;
        double sheen;
        double anisotropy;
        double anisotropyRotation;
        Optional<MtlImage> texture = Optional.empty();
        Optional<MtlImage> emissionMap = Optional.empty();
        Optional<MtlImage> cutout = Optional.empty();
        Optional<MtlImage> bump = Optional.empty();
        Optional<MtlImage> roughnessMap = Optional.empty();
        Optional<MtlImage> metalnessMap = Optional.empty();
        Optional<MtlImage> coatMap = Optional.empty();
        Optional<MtlImage> coatRoughnessMap = Optional.empty();

        MaterialBuilder(String name) {
            this.name = name;
        }

        /** Sets the bump map; one that is surely a normal map wins. */
        void setBump(Optional<MtlImage> image) {
            bump = bump.filter(MtlImage::isNormal).or(() -> image);
        }

        private Optional<MtlMaterial.Physical> physical() {
            return roughness.isEmpty() && metalness.isEmpty() && roughnessMap.isEmpty() && metalnessMap.isEmpty()
                    && coat == 0 && sheen == 0 && anisotropy == 0 && coatMap.isEmpty() ? Optional.empty()
                            : Optional.of(new MtlMaterial.Physical(roughness.orElse(MtlMaterial.Physical.NONE.roughness()),
                                    metalness.orElse(0),
                                    coat, coatRoughness, sheen, anisotropy, anisotropyRotation, factorMap(roughnessMap, roughness),
                                    factorMap(metalnessMap, metalness), factorMap(coatMap, OptionalDouble.of(coat)),
                                    factorMap(coatRoughnessMap, OptionalDouble.of(coatRoughness))));
        }

        private static Optional<MtlMaterial.FactorMap> factorMap(Optional<MtlImage> map, OptionalDouble factor) {
            return map.map(image -> new MtlMaterial.FactorMap(image, factor.orElse(0) == 0 ? 1 : factor.getAsDouble()));
        }

        MtlMaterial build() {
            return new MtlMaterial(name, illumination, diffuse, specular, emission, shininess, effectiveOpacity(),
                    filter == null ? Rgb.WHITE : filter,
                    ior, texture, emissionMap, cutout, bump, physical());
        }

        /**
         * Returns the opacity, from d, or from Tr if there is no d. Some writers use Tr 1 for opaque; it is treated so if it
         * is alone and the model does not transmit light. Models with refraction ignore opacity; their filter alone defines
         * the transmission.
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

    /** Parses the last token as a number. */
    private double parseNumber() throws MeshException {
        if (text.length() == 0) {
            throw text.badLine("expected a number, found the end of the line");
        }
        return text.number("it");
    }

    /** Reads a color, empty if it is not RGB; a single number applies to all channels. */
    private Optional<Rgb> readColor() throws IOException, MeshException {
        if (text.readToken() && (text.isToken("spectral") || text.isToken("xyz"))) {
            notes.add("material colors other than RGB");
            return Optional.empty();
        }
        double red = text.number("red");
        if (!text.readToken()) {
            return Optional.of(Rgb.gray(red));
        }
        return Optional.of(new Rgb(red, text.number("green"), readNumber()));
    }

    /**
     * Reads the path after the options; each option is a word with a hyphen and its arguments.
     *
     * @param isNormal true if the statement is for normal maps
     */
    private Optional<MtlImage> readImage(boolean isNormal) throws IOException, MeshException {
        String rest = text.restOfLine();
        double multiplier = 1;
        double[] scale = {1, 1};
        double[] offset = {0, 0};
        boolean isClamped = false;
        while (rest.startsWith("-")) {
            String[] words = rest.split("\\s+", 2);
            rest = words.length < 2 ? "" : words[1];
            String option = words[0];
            int most = switch (option) {
                case "-mm" -> 2;
                case "-o", "-s", "-t" -> 3;
                default -> 1;
            };
            double[] numbers = new double[most];
            int count = 0;
            String first = rest.split("\\s+", 2)[0];
            // The last arguments of -o, -s and -t are optional.
            while (count < most && !rest.isEmpty() && (count == 0 || NUMBER.matcher(rest.split("\\s+", 2)[0]).matches())) {
                String[] argument = rest.split("\\s+", 2);
                numbers[count++] = DecimalNumber.parse(argument[0]).orElse(Double.NaN);
                rest = argument.length < 2 ? "" : argument[1];
            }
            boolean isRead = count > 0 && Double.isFinite(numbers[0]) && (count < 2 || Double.isFinite(numbers[1]));
            switch (option) {
                case "-bm" -> multiplier = isRead ? numbers[0] : 1;
                case "-s" -> scale = isRead ? new double[] {numbers[0], count > 1 ? numbers[1] : 1} : scale;
                case "-o" -> offset = isRead ? new double[] {numbers[0], count > 1 ? numbers[1] : 0} : offset;
                case "-clamp" -> {
                    isClamped = first.equals("on");
                    isRead = isClamped || first.equals("off");
                }
                default -> isRead = false;
            }
            notes.add("options " + option + " of textures", isRead ? 0 : 1);
        }
        return rest.isEmpty() ? Optional.empty()
                : Optional.of(new MtlImage(rest, isNormal, multiplier, scale[0], scale[1], offset[0], offset[1], isClamped));
    }
}
