package lightning.format.jen;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.scene.Group;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.shot.Key;
import lightning.scene.shot.Setting;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Target;
import lightning.scene.shot.Track;

/** Writes a shot as its block. */
final class ShotText {
    private static final String INDENT = "  ";

    private final Scene scene;
    private final String newline;

    ShotText(Scene scene, String newline) {
        this.scene = scene;
        this.newline = newline;
    }

    /** The block without a line end behind it. */
    String block(Shot shot) {
        List<String> lines = new ArrayList<>();
        Element head = Element.of(Blocks.SHOT, shot);
        Blocks.SHOT.properties().stream().filter(head::mustSay)
                .forEach(p -> lines.add(INDENT + JenWriter.property(p, head.values().get(p.name()))));
        Map<Target, List<Track>> targets = new LinkedHashMap<>();
        shot.tracks().forEach(t -> targets.computeIfAbsent(t.target(), _ -> new ArrayList<>()).add(t));
        targets.forEach((target, tracks) -> {
            lines.add(INDENT + head(target) + " {");
            tracks.forEach(t -> lines.add(keys(t)));
            lines.add(INDENT + "}");
        });
        return lines.isEmpty() ? "shot {}" : "shot {" + newline + String.join(newline, lines) + newline + "}";
    }

    /** What stands before the brace of what has keys. */
    String head(Target target) {
        String keyword = type(scene, target).keyword();
        return target.name().isEmpty() ? keyword : keyword + " " + NameText.of(target.name());
    }

    /** The block that says in a file what has keys. */
    static BlockType<?> type(Scene scene, Target target) {
        return switch (target.what()) {
            case CAMERA -> Blocks.CAMERA;
            case LIGHT -> Blocks.LIGHT;
            case BANK -> Blocks.BANK;
            case NODE -> switch (scene.stage().node(target.name()).orElseThrow()) {
                case Group _ -> Blocks.GROUP;
                case Shape s -> Blocks.of(s.solid());
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
        return line.length() <= JenWriter.LINE ? line : indent + track.attribute() + " {" + newline
                + keys.stream().map(k -> indent + INDENT + k + newline).collect(Collectors.joining()) + indent + "}";
    }

    private static String key(Property<?> property, Key key) {
        Value value = switch (key.setting()) {
            case Setting.Numbers(List<Double> all) -> new Value.Numbers(all);
            case Setting.Word(String text) -> new Value.Word(text);
        };
        return key.frame() + " " + value.text() + KeyParser.text(property, key.passage());
    }
}
