"""What QGIS knows of the way to the network, in the form in which pip takes it: proxies as variables, certificates as a file."""

from __future__ import annotations

from urllib.parse import quote

from qgis.core import QgsApplication, QgsAuthCertUtils, QgsNetworkAccessManager
from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtNetwork import QNetworkProxy, QNetworkProxyQuery

REGISTRY = "https://pypi.org/simple/"
"""The registry that pip asks unless it was told otherwise; proxies are chosen for it."""


def proxy_variables() -> dict[str, str]:
    """Variables with the proxy that QGIS uses for the registry; empty where it uses none, so that those of the system stay."""
    manager = QgsNetworkAccessManager.instance()
    query = QNetworkProxyQuery(QUrl(REGISTRY))
    factory = manager.proxyFactory()
    proxies = factory.queryProxy(query) if factory is not None else [manager.fallbackProxy()]
    address = next((found for found in map(proxy_address, proxies) if found), "")
    if not address:
        return {}
    excluded = [text for text in manager.noProxyList() if text]
    hosts = ",".join(QUrl(text).host() or text for text in excluded)
    variables = {"HTTP_PROXY": address, "HTTPS_PROXY": address, "http_proxy": address, "https_proxy": address}
    return variables | ({"NO_PROXY": hosts, "no_proxy": hosts} if hosts else {})


def proxy_address(proxy: QNetworkProxy) -> str:
    """A proxy as an address; empty for none, and for kinds that lead to no registry."""
    kinds = {
        QNetworkProxy.ProxyType.HttpProxy: "http",
        QNetworkProxy.ProxyType.HttpCachingProxy: "http",
        QNetworkProxy.ProxyType.Socks5Proxy: "socks5h",
    }
    scheme = kinds.get(proxy.type())
    if scheme is None or not proxy.hostName():
        return ""
    # names and passwords hold any letters
    person = f"{quote(proxy.user(), safe='')}:{quote(proxy.password(), safe='')}@" if proxy.user() else ""
    port = f":{proxy.port()}" if proxy.port() else ""
    return f"{scheme}://{person}{proxy.hostName()}{port}"


def added_certificates() -> str:
    """Certificates of authorities that the user gave QGIS, as PEM; empty if there are none."""
    manager = QgsApplication.authManager()
    if manager.isDisabled():
        return ""
    given = [*manager.databaseCAs(), *manager.extraFileCAs()]
    return bytes(QgsAuthCertUtils.certsToPemText(given)).decode("ascii", "replace") if given else ""
