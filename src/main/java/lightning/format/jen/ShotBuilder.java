package lightning.format.jen;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Target;
import lightning.scene.shot.Track;

/** Makes the shot of a scene from the block of a file and finds what is wrong between that and the scene. */
final class ShotBuilder {
    private final Tokens tokens;
    private final Problems problems;
    private final Scene scene;

    ShotBuilder(Tokens tokens, Problems problems, Scene scene) {
        this.tokens = tokens;
        this.problems = problems;
        this.scene = scene;
    }

    /** The shot, or nothing where there is none or a problem. */
    Optional<Shot> build(List<Block> blocks) {
        Block block = blocks.stream().filter(b -> b.type == Blocks.SHOT).findFirst().orElse(null);
        if (block == null) {
            return Optional.empty();
        }
        List<Track> tracks = new ArrayList<>();
        Map<Target, Block> seen = new HashMap<>();
        for (Block child : block.children) {
            Target target = target(child);
            if (!isThere(child)) {
                problem(child, "there is no " + child.title() + " in the scene" + Nearest.hint(child.name, scene.lights().stream()
                        .map(l -> l.name()).filter(_ -> child.type == Blocks.LIGHT).toList()));
            } else if (seen.put(target, child) != null) {
                problem(child, child.title() + " must have its keys in one block, found another");
            } else {
                child.keys.stream().filter(k -> !k.keys().isEmpty()).forEach(k -> track(child, target, k).ifPresent(tracks::add));
            }
        }
        try {
            Shot shot = Blocks.SHOT.builder().build("", new Values(block::value, null), List.of()).withTracks(tracks);
            return problems.isEmpty() ? Optional.of(shot) : Optional.empty();
        } catch (IllegalArgumentException e) {
            problem(block, "shot: " + e.getMessage());
            return Optional.empty();
        }
    }

    private Optional<Track> track(Block child, Target target, Block.Keys keys) {
        try {
            Track track = new Track(target, keys.property().name(), keys.keys());
            track.check(scene);
            return Optional.of(track);
        } catch (IllegalArgumentException e) {
            problems.add(tokens.start(keys.nameToken()), child.title() + ": " + e.getMessage());
            return Optional.empty();
        }
    }

    static Target target(Block child) {
        return child.type == Blocks.CAMERA ? Target.CAMERA : child.type == Blocks.LIGHT ? Target.light(child.name)
                : child.type == Blocks.BANK ? Target.bank(child.name) : Target.node(child.name);
    }

    private boolean isThere(Block child) {
        Target target = target(child);
        return target.isIn(scene) && ShotText.type(scene, target) == child.type;
    }

    private void problem(Block block, String message) {
        problems.add(tokens.start(block.place()), message);
    }
}
