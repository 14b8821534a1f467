package lightning.format.jen;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.scene.Scene;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.Shape;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import lightning.scene.shot.TrackTarget;

/** Writer for shot blocks. */
record ShotWriter(Scene scene, String newline) {
    private static final String INDENT = "  ";

    /** Returns the block, without a final line end. */
    String block(Shot shot) {
        List<String> lines = new ArrayList<>();
        BlockContent content = BlockContent.of(BlockTypes.SHOT, shot);
        BlockTypes.SHOT.properties().stream().filter(content::mustWrite)
                .forEach(p -> lines.add(INDENT + JenWriter.property(p, content.value(p))));
        Map<TrackTarget, List<Track>> targets = new LinkedHashMap<>();
        shot.tracks().forEach(t -> targets.computeIfAbsent(t.target(), _ -> new ArrayList<>()).add(t));
        targets.forEach((target, tracks) -> {
            lines.add(INDENT + header(target) + " {");
            tracks.forEach(t -> lines.add(keys(t)));
            lines.add(INDENT + "}");
        });
        return lines.isEmpty() ? "shot {}" : "shot {" + newline + String.join(newline, lines) + newline + "}";
    }

    /** Returns the text before the brace of an animated block. */
    String header(TrackTarget target) {
        String keyword = type(scene, target).keyword();
        return target.name().isEmpty() ? keyword : keyword + " " + NameSyntax.format(target.name());
    }

    /** Returns the block type of an animated object. */
    static BlockType<?> type(Scene scene, TrackTarget target) {
        return switch (target.kind()) {
            case CAMERA -> BlockTypes.CAMERA;
            case LIGHT -> BlockTypes.LIGHT;
            case LIGHT_GROUP -> BlockTypes.LIGHT_GROUP;
            case DOME -> BlockTypes.DOME;
            case NODE -> switch (scene.stage().node(target.name()).orElseThrow()) {
                case NodeGroup _ -> BlockTypes.GROUP;
                case Shape s -> BlockTypes.of(s.solid());
            };
        };
    }

    private String keys(Track track) {
        BlockType<?> type = type(scene, track.target());
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
