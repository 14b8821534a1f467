package lightning.format.jen;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;

/** Writer for shot blocks. */
record ShotWriter(Scene scene, String newline) {
    private static final String INDENT = "  ";

    /** Returns the block, without a final line end. */
    String block(Shot shot) {
        List<String> lines = new ArrayList<>();
        BlockContent content = BlockContent.of(BlockTypes.SHOT, shot);
        BlockTypes.SHOT.properties().stream().filter(content::mustWrite)
                .forEach(p -> lines.add(INDENT + JenWriter.property(p, content.value(p))));
        Map<SceneElement<?>, List<Track>> targets = new LinkedHashMap<>();
        shot.tracks().forEach(t -> targets.computeIfAbsent(t.target(), _ -> new ArrayList<>()).add(t));
        targets.forEach((target, tracks) -> {
            lines.add(INDENT + header(target) + " {");
            tracks.forEach(t -> lines.add(keys(t)));
            lines.add(INDENT + "}");
        });
        return lines.isEmpty() ? "shot {}" : "shot {" + newline + String.join(newline, lines) + newline + "}";
    }

    /** Returns the text before the brace of an animated block. */
    String header(SceneElement<?> target) {
        String keyword = BlockTypes.of(scene, target).keyword();
        return target.name().isEmpty() ? keyword : keyword + " " + NameSyntax.format(target.name());
    }

    private String keys(Track track) {
        BlockType<?> type = BlockTypes.of(scene, track.target());
        Property<?> property = Stream.concat(type.header().stream(), type.properties().stream())
                .filter(p -> p.name().equals(track.attribute())).findFirst().orElseThrow();
        String indent = INDENT + INDENT;
        List<String> keys = track.keys().stream().map(k -> key(property, k)).toList();
        String line = indent + track.attribute() + " { " + String.join("  ", keys) + " }";
        return line.length() <= JenWriter.MAX_LINE_LENGTH ? line : indent + track.attribute() + " {" + newline
                + keys.stream().map(k -> indent + INDENT + k + newline).collect(Collectors.joining()) + indent + "}";
    }

    private static String key(Property<?> property, Keyframe key) {
        Value value = switch (key.value()) {
            case KeyframeValue.Numbers(List<Double> all) -> new Value.Numbers(all);
            case KeyframeValue.Word(String text) -> new Value.Word(text);
        };
        return key.frame() + " " + value.text() + KeyframeParser.text(property, key.interpolation());
    }
}
