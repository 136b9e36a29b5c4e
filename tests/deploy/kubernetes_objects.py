"""Checks the objects of deploy/kubernetes as typed values, and that what they say of each other is true.
Usage: kubernetes_objects.py FILE: the output of `kubectl kustomize`. Needs python3-kubernetes, whose
classes are made from the schema of the API; no cluster and no network."""
import copy
import re
import sys

import yaml
from kubernetes.client import models

PLAIN = {"str": str, "int": int, "bool": bool, "float": (int, float)}


class Wrong(Exception):
    pass


def check_value(value, kind, path):
    """Raises Wrong where `value` is not of the type that the API's schema names `kind`."""
    listed = re.fullmatch(r"list\[(.+)\]", kind)
    mapped = re.fullmatch(r"dict\(str, (.+)\)", kind)
    if kind == "object":  # An integer or a name, for example the port of a probe.
        return
    if listed or mapped:
        if not isinstance(value, list if listed else dict):
            raise Wrong(f"{path}: {value!r} is no {kind}")
        for key, each in enumerate(value) if listed else value.items():
            check_value(each, (listed or mapped).group(1), f"{path}[{key}]")
    elif kind in PLAIN:
        if not isinstance(value, PLAIN[kind]) or (kind != "bool" and isinstance(value, bool)):
            raise Wrong(f"{path}: {value!r} is no {kind}")
    else:
        check_object(value, getattr(models, kind), path)


def check_object(value, model, path):
    if not isinstance(value, dict):
        raise Wrong(f"{path}: {value!r} is no {model.__name__}")
    attributes = {key: name for name, key in model.attribute_map.items()}
    given = {}
    for key, each in value.items():
        if key not in attributes:
            raise Wrong(f"{path}.{key}: {model.__name__} has no such key")
        check_value(each, model.openapi_types[attributes[key]], f"{path}.{key}")
        given[attributes[key]] = each
    try:
        model(**given)  # Refuses an object that lacks a required key, or has a value out of range.
    except ValueError as error:
        raise Wrong(f"{path}: {error}") from error


def check_typed(item):
    group, _, version = item["apiVersion"].rpartition("/")
    if item["kind"] not in KINDS or KINDS[item["kind"]] != item["apiVersion"]:
        raise Wrong(f"{item['apiVersion']} {item['kind']} is not expected here")
    check_object(item, getattr(models, version.capitalize() + item["kind"]), item["kind"])


KINDS = {
    "Namespace": "v1", "Service": "v1", "ConfigMap": "v1", "ServiceAccount": "v1", "Secret": "v1",
    "StatefulSet": "apps/v1", "Deployment": "apps/v1", "Job": "batch/v1",
    "Role": "rbac.authorization.k8s.io/v1", "RoleBinding": "rbac.authorization.k8s.io/v1",
    "NetworkPolicy": "networking.k8s.io/v1",
}


def must(holds, text):
    if not holds:
        raise Wrong(text)


def containers_of(pod):
    return pod.get("initContainers", []) + pod["containers"]


def check_pod(name, pod):
    """A pod is not root, cannot become it, writes to its volumes alone, and mounts volumes that exist."""
    security = pod["securityContext"]
    must(security["runAsNonRoot"] and security["runAsUser"] > 0, f"{name} runs as root")
    must(security["seccompProfile"]["type"] == "RuntimeDefault", f"{name} has no seccomp profile")
    volumes = {volume["name"] for volume in pod["volumes"]}
    for container in containers_of(pod):
        own = container["securityContext"]
        where = f"{name}/{container['name']}"
        must(own["readOnlyRootFilesystem"], f"{where} has a root file system that can be written")
        must(not own["allowPrivilegeEscalation"], f"{where} may get privileges")
        must(own["capabilities"] == {"drop": ["ALL"]}, f"{where} has capabilities")
        for mount in container["volumeMounts"]:
            must(mount["name"] in volumes, f"{where} mounts {mount['name']}, which is no volume")
        for probe in ("startupProbe", "livenessProbe", "readinessProbe"):
            if probe in container:
                port = container[probe]["httpGet"]["port"]
                must(port in {each["name"] for each in container["ports"]}, f"{where}: no port {port}")


def pods_of(items):
    """The pods of the templates, by name; those of a StatefulSet with the volumes that it claims."""
    pods = {}
    for item in items:
        if item["kind"] in ("StatefulSet", "Deployment", "Job"):
            pod = copy.deepcopy(item["spec"]["template"]["spec"])
            for claim in item["spec"].get("volumeClaimTemplates", []):
                pod["volumes"].append({"name": claim["metadata"]["name"]})
            pods[item["metadata"]["name"]] = (item["spec"]["template"]["metadata"]["labels"], pod)
    return pods


def check_together(items):
    names = {(item["kind"], item["metadata"]["name"]): item for item in items}
    pods = pods_of(items)
    for name, (labels, pod) in pods.items():
        check_pod(name, pod)
        for container in containers_of(pod):
            for source in container.get("envFrom", []):
                must(("ConfigMap", source["configMapRef"]["name"]) in names, f"{name}: no such ConfigMap")
    for item in items:
        name = item["metadata"]["name"]
        if item["kind"] == "Namespace":
            continue
        must(item["metadata"].get("namespace") == "cdcluster", f"{name} is in no namespace")
        if item["kind"] in ("StatefulSet", "Deployment"):
            must(item["spec"]["selector"]["matchLabels"].items() <= pods[name][0].items(), f"{name} selects others")
        if item["kind"] == "StatefulSet":
            must(("Service", item["spec"]["serviceName"]) in names, f"{name}: no such Service")
        if item["kind"] == "Service":
            chosen = [pod for labels, pod in pods.values() if item["spec"]["selector"].items() <= labels.items()]
            must(len(chosen) == 1, f"Service {name} chooses {len(chosen)} pods")
            ports = {port["name"]: port["containerPort"] for port in chosen[0]["containers"][0]["ports"]}
            for port in item["spec"]["ports"]:
                must(ports[port["targetPort"]] == port["port"], f"Service {name}: port {port['name']}")
        if item["kind"] == "NetworkPolicy":
            chosen = [labels for labels, _ in pods.values()
                      if item["spec"]["podSelector"]["matchLabels"].items() <= labels.items()]
            must(len(chosen) == 1, f"NetworkPolicy {name} chooses {len(chosen)} pods")
        if item["kind"] == "RoleBinding":
            must(("Role", item["roleRef"]["name"]) in names, f"{name}: no such Role")
            for subject in item["subjects"]:
                account = names[("ServiceAccount", subject["name"])]
                must(account["metadata"]["namespace"] == subject.get("namespace"), f"{name}: another namespace")
    must(set(pods) == {item["metadata"]["name"] for item in items if item["kind"] == "NetworkPolicy"},
         "each pod needs a NetworkPolicy")


def check_that_wrong_objects_fail(items):
    """Each mistake, made in a copy, must be found, or the checks say nothing."""
    def of(kind, copies):
        return next(item for item in copies if item["kind"] == kind)

    mistakes = [
        lambda all: of("StatefulSet", all)["spec"].update(replica=1),
        lambda all: of("StatefulSet", all)["spec"].update(replicas="1"),
        lambda all: of("StatefulSet", all)["spec"].pop("selector"),
        lambda all: of("Deployment", all)["spec"]["template"]["spec"]["containers"][0].update(arg=["worker"]),
        lambda all: of("Deployment", all)["spec"]["template"]["spec"]["containers"][0].update(args="worker"),
        lambda all: of("Deployment", all)["spec"]["template"]["spec"]["securityContext"].update(runAsUser=0),
        lambda all: of("Deployment", all)["spec"]["template"]["metadata"]["labels"].update(app="other"),
        lambda all: of("Job", all)["spec"]["template"]["spec"]["volumes"].pop(),
        lambda all: of("NetworkPolicy", all)["spec"].update(ingres=[]),
        lambda all: of("RoleBinding", all)["subjects"][0].pop("namespace"),
        lambda all: of("Service", all)["spec"]["ports"][0].update(port=7601),
    ]
    for number, mistake in enumerate(mistakes):
        copies = copy.deepcopy(items)
        mistake(copies)
        try:
            for item in copies:
                check_typed(item)
            check_together(copies)
        except Wrong:
            continue
        raise Wrong(f"mistake {number} is not found")
    return len(mistakes)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        items = [item for item in yaml.safe_load_all(file) if item]
    for item in items:
        check_typed(item)
    check_together(items)
    print(f"kubernetes: {len(items)} objects are right, {check_that_wrong_objects_fail(items)} wrong ones are refused")


if __name__ == "__main__":
    try:
        main()
    except Wrong as wrong:
        sys.exit(f"kubernetes: FAILED: {wrong}")
