package lightning.format.jen;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;

/** Generator of scene texts from the grammar, about half of them with an error. */
final class RandomJenText {
    /** File of every mesh, which must exist. */
    static final String MESH = "a.ply";

    private static final String[] MISTAKES = {"nan", "}", "{", "\"", "-1e999", "light", "0.1.2", "§", "\u0000", "\"", "\"a\\b\"", "\"\\\"",
        "\"\"", "\" a\"", "\"\u202E\"", "𝐀".repeat(41), "'", "1e", "x y z",
        "\"../a.png\"", "jen 1", "camera {", "on on", "\ud83d\ude00", "99999999999999999999", "-"};

    private static final String[] NAMES = {"n", "n", "n", "old oak ", "3.", "\"", "\\", "=", "{ } # ", "नाम", "e\u0301", "𝐀 ", "n'"};

    private final SplittableRandom random;
    private final StringBuilder out = new StringBuilder();
    private final List<String> materials = new ArrayList<>();
    private final List<String> nodes = new ArrayList<>();
    private final List<String> groupNames = new ArrayList<>();
    /** Probability of an error at each position, 1 in this number; 0 for none. */
    private final int mistakes;
    private int names;

    RandomJenText(SplittableRandom random) {
        this.random = random;
        this.mistakes = random.nextInt(100) < 40 ? 0 : 2 + random.nextInt(60);
    }

    String appendFile() {
        out.append("jen 1\n");
        for (BlockType<?> type : List.of(BlockTypes.PICTURE, BlockTypes.CAMERA, BlockTypes.WORLD)) {
            if (random.nextBoolean()) {
                block(type, 0);
            }
        }
        for (int i = random.nextInt(8); i > 0; i--) {
            String keyword = BlockTypes.KEYWORDS.get(random.nextInt(BlockTypes.KEYWORDS.size()));
            BlockType<?> type = BlockTypes.of(keyword).orElseThrow();
            if (type.isNamed() || mistake()) {
                block(type, 0);
            }
        }
        return out.toString();
    }

    private void block(BlockType<?> type, int nesting) {
        word(type.keyword());
        if (type.isNamed()) {
            String name = NAMES[random.nextInt(NAMES.length)] + (mistake() ? 0 : names++);
            if (type == BlockTypes.MATERIAL) {
                materials.add(name);
            }
            if (BlockTypes.NODE_KEYWORDS.contains(type.keyword())) {
                nodes.add(name);
            }
            if (type == BlockTypes.LIGHT_GROUP) {
                groupNames.add(name);
            }
            String text = NameSyntax.format(name);
            word(random.nextInt(8) == 0 && text.equals(name) ? '"' + name + '"' : text);
        }
        type.header().ifPresent(p -> word(p.choices().get(random.nextInt(p.choices().size()))));
        word("{");
        properties(type);
        if (type == BlockTypes.GROUP && nesting < 5) {
            for (int i = random.nextInt(3); i > 0; i--) {
                block(BlockTypes.of(BlockTypes.NODE_KEYWORDS.get(random.nextInt(BlockTypes.NODE_KEYWORDS.size()))).orElseThrow(),
                        nesting + 1);
            }
        }
        word("}");
    }

    private void properties(BlockType<?> type) {
        for (Property<?> p : type.properties()) {
            boolean file = p.name().equals(BlockTypes.FILE) && type.keyword().equals("mesh");
            boolean missing = p.form() == Property.Form.QUOTED || p.unit().contains(", needs a ") || p.name().equals(BlockTypes.PART)
                    || p.name().equals("bank") && groupNames.isEmpty()
                    || (p.name().equals("gains") || p.name().equals("shape")) && nodes.isEmpty();
            if (file ? !mistake() : missing ? mistake() : random.nextInt(3) == 0) {
                word(p.name());
                value(p);
            }
        }
    }

    private void value(Property<?> p) {
        if (p.name().equals("gains") && !nodes.isEmpty()) {
            word(NameSyntax.quote(nodes.get(random.nextInt(nodes.size()))));
            word(Double.toString(random.nextDouble(100)));
            return;
        }
        switch (p.form()) {
            case NUMBERS -> {
                for (int i = 0; i < p.count(); i++) {
                    word(number(p, i));
                }
            }
            case WORD -> word(p.choices().get(random.nextInt(p.choices().size())));
            case LINKS -> links();
            case NAME -> word(NameSyntax.format(switch (p.name()) {
                case "bank" -> groupName();
                case "shape" -> nodes.isEmpty() ? "none of them" : nodes.get(random.nextInt(nodes.size()));
                default -> material();
            }));
            case BLOCK -> {
                word("{");
                properties(BlockTypes.nested(p));
                word("}");
            }
            case QUOTED -> word(p.name().equals(BlockTypes.FILE) ? '"' + MESH + '"' : "\"a.png\"");
        }
    }

    private void links() {
        if (nodes.isEmpty() || random.nextInt(3) == 0) {
            word(random.nextBoolean() ? "all" : "none");
            return;
        }
        word(random.nextBoolean() ? "only" : "except");
        int first = random.nextInt(nodes.size());
        for (int i = first; i < nodes.size() && (i == first || random.nextInt(3) > 0); i++) {
            word(NameSyntax.quote(nodes.get(i)));
        }
    }

    private String material() {
        return materials.isEmpty() || random.nextInt(4) == 0 ? "default" : materials.get(random.nextInt(materials.size()));
    }

    private String groupName() {
        return groupNames.isEmpty() ? "none of them" : groupNames.get(random.nextInt(groupNames.size()));
    }

    private String number(Property<?> p, int index) {
        if (p.name().equals("rays") && !mistake()) {
            return Integer.toString(IndirectSettings.RAY_COUNTS.get(random.nextInt(IndirectSettings.RAY_COUNTS.size())));
        }
        if (p.name().equals("reflection_rays") && !mistake()) {
            return Integer.toString(
                    PictureSettings.REFLECTION_RAY_COUNTS.get(random.nextInt(PictureSettings.REFLECTION_RAY_COUNTS.size())));
        }
        if (p.isInteger()) {
            return Integer.toString(random.nextInt((int) p.min(), (int) p.max() + 1));
        }
        if (mistake()) {
            return Double.toString(Double.longBitsToDouble(random.nextLong()));
        }
        // Scales stay between ½ and 2, so that the product over nested groups stays in range.
        double v = p.name().equals("scale") ? 0.5 + 1.5 * random.nextDouble()
                : p.min() + (p.max() - p.min()) * random.nextDouble();
        return Double.toString(index == 0 && p.min() <= 0 && !p.name().equals("scale") && random.nextBoolean() ? 0.5 : v);
    }

    private void word(String word) {
        if (mistake()) {
            int kind = random.nextInt(4);
            if (kind == 0) {
                return;
            }
            out.append(kind == 1 ? word.substring(random.nextInt(word.length())) : MISTAKES[random.nextInt(MISTAKES.length)]).append(' ');
            if (kind == 2) {
                return;
            }
        }
        out.append(word).append(switch (random.nextInt(12)) {
            case 0 -> " # comment { \"\n";
            case 1 -> "\r\n";
            case 2 -> "\t\t";
            default -> " ";
        });
    }

    private boolean mistake() {
        return mistakes > 0 && random.nextInt(mistakes) == 0;
    }
}
