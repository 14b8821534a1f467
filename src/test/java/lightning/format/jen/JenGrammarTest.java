package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Stream;
import lightning.scene.shot.Interpolation;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;

/**
 * Tests that the TextMate grammar for text editors has the words of the format. {@link #main} writes it again after a change of the format.
 */
class JenGrammarTest {
    private static final Path FILE = Path.of("src/main/grammar/jen.tmLanguage.json");
    /** Words of a shot's tracks, and of the file's first line. */
    private static final List<String> OTHER_KEYWORDS = List.of("jen", "track");

    @Test
    void grammar_hasAllWordsOfTheFormat() throws IOException {
        assertThat(Files.readString(FILE)).isEqualTo(grammar());
    }

    @Test
    void patterns_matchAWholeScene() throws IOException {
        String words = pattern(properties());
        assertThat("attenuation").matches(words);
        assertThat("intensity").matches(words);
        assertThat("light").matches(pattern(keywords()));
        assertThat("directional").matches(pattern(choices()));
        assertThat("-1.5e-3").matches(NUMBER);
    }

    private static final String NUMBER = "(?<![\\w.])[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?(?![\\w.])";

    public static void main(String... args) throws IOException {
        Files.writeString(FILE, grammar());
    }

    private static Stream<BlockType<?>> types() {
        return BlockTypes.KEYWORDS.stream().map(keyword -> BlockTypes.of(keyword).orElseThrow());
    }

    private static TreeSet<String> keywords() {
        return new TreeSet<>(Stream.concat(BlockTypes.KEYWORDS.stream(), OTHER_KEYWORDS.stream()).toList());
    }

    private static TreeSet<String> properties() {
        TreeSet<String> names =
                new TreeSet<>(Stream.concat(types(), Stream.of(BlockTypes.INDIRECT)).flatMap(t -> t.propertyNames().stream())
                        .toList());
        names.removeAll(keywords());
        return names;
    }

    private static TreeSet<String> choices() {
        TreeSet<String> words = new TreeSet<>(List.of("none", "all", "only", "except", "yes", "no"));
        types().forEach(type -> {
            type.properties().forEach(property -> words.addAll(property.choices()));
            type.header().ifPresent(property -> words.addAll(property.choices()));
        });
        Stream.of(Interpolation.values()).forEach(kind -> words.add(kind.name().toLowerCase(java.util.Locale.ROOT)));
        words.removeIf(word -> !word.matches("[a-z_][\\w-]*"));
        return words;
    }

    /** Longest words first, because an alternative that is the start of another would match first. */
    private static String pattern(TreeSet<String> words) {
        return "\\b(?:" + String.join("|", words.stream().sorted(Comparator.comparing(String::length).reversed()
                .thenComparing(Comparator.naturalOrder())).toList()) + ")\\b";
    }

    private static String grammar() {
        Map<String, Object> grammar = new LinkedHashMap<>();
        grammar.put("name", "Lightning Scene");
        grammar.put("scopeName", "source.jen");
        grammar.put("fileTypes", List.of("jen"));
        grammar.put("patterns", List.of(
                rule("comment.line.number-sign.jen", "#.*$"),
                rule("string.quoted.double.jen", "\"[^\"]*\""),
                rule("constant.numeric.jen", NUMBER),
                rule("keyword.control.jen", pattern(keywords())),
                rule("variable.parameter.jen", pattern(properties())),
                rule("constant.language.jen", pattern(choices())),
                rule("punctuation.section.block.jen", "[{}]")));
        return JsonMapper.builder().enable(SerializationFeature.INDENT_OUTPUT).build().writeValueAsString(grammar) + "\n";
    }

    private static Map<String, String> rule(String scope, String pattern) {
        Map<String, String> rule = new LinkedHashMap<>();
        rule.put("name", scope);
        rule.put("match", pattern);
        return rule;
    }
}
